// surfaces: shapes drawn by Open CASCADE's exact hidden-line removal, which knows their surfaces, and by hsr, which knows triangles of them:
// times, lengths of lines, and how much these differ. Nothing passes or fails by time.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <BRepAdaptor_Curve.hxx>
#include <CLI/CLI.hpp>
#include <GCPnts_QuasiUniformDeflection.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/seconds.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/step/step.h"
#include "tests/step/shapes.h"
#include "tests/step/surface_lines.h"

namespace hsr::bench {
namespace {

using namespace shapes;

struct Request {
  std::vector<std::string> shapes;
  std::vector<double> chords = {0.02, 0.002};
  std::string pictures;
  int repeat = 3;
};

/// What Open CASCADE draws, as SVG: for who wants to see where the two differ.
void write_picture(const std::string& file, const TopoDS_Shape& lines) {
  std::string paths;
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (TopExp_Explorer at(lines, TopAbs_EDGE); at.More(); at.Next()) {
    BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));
    const GCPnts_QuasiUniformDeflection points(curve, 0.002);
    if (!points.IsDone()) continue;
    for (int k = 1; k <= points.NbPoints(); ++k) {
      const double p[2] = {points.Value(k).X(), -points.Value(k).Y()};
      for (int i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
      paths += fmt::format("{}{:.4f},{:.4f}", k == 1 ? "<path d=\"M" : " ", p[0], p[1]);
    }
    paths += "\"/>\n";
  }
  std::ofstream(file) << fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.4f} {:.4f} {:.4f} {:.4f}\">\n",
                                     low[0] - 1, low[1] - 1, high[0] - low[0] + 2, high[1] - low[1] + 2)
                      << "<g fill=\"none\" stroke=\"#000\" stroke-width=\"0.15\">\n"
                      << paths << "</g>\n</svg>\n";
}

std::string text_of(const std::vector<double>& times) { return fmt::format("{:.3g}", seconds(times).median); }

/// A row for each chord.
void measure(const ComparedShape& compared, const Request& request) {
  const View view = compared_view();
  Times of_surfaces;
  Lengths expected;
  for (int k = 0; k < request.repeat; ++k) {
    SurfaceLines surfaces(compared.shape);
    of_surfaces.add(elapsed([&] { surfaces.find(view); }));
    expected = surfaces.lengths();
    if (!request.pictures.empty()) write_picture(request.pictures + "/" + compared.name + ".svg", surfaces.visible());
  }
  const std::string file = request.pictures.empty() ? (std::filesystem::temp_directory_path() / "hsr-surfaces.step").string()
                                                    : request.pictures + "/" + compared.name + ".step";
  write_step(compared.shape, file);
  for (const double chord : request.chords) {
    Times meshes, lines;
    Model model;
    for (int k = 0; k < request.repeat; ++k) {
      const BrepModel brep = read_brep(file);
      meshes.add(elapsed([&] { model = brep.tessellated(chord); }));
      lines.add(elapsed([&] {
        LineOptions options;
        options.classes.fill(true);
        (void)visible_lines(SceneView(Scene::of(make_mesh(model.points, model.polygons), labels_of(model)), view), options);
      }));
    }
    const Lengths found = lengths_by_hsr(model, view);
    fmt::print("| {} | {:g} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:+.2f} | {:.1f} |\n", compared.name, chord,
               model.polygons.size(), text_of(of_surfaces.processor), text_of(meshes.processor), text_of(lines.processor),
               expected.edges, found.edges, found.edges - expected.edges, bound_of(compared, chord));
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  Request request;
  CLI::App app("Shapes drawn by Open CASCADE's exact hidden-line removal and by hsr");
  app.add_option("--shape", request.shapes, "Only these");
  app.add_option("--chord", request.chords, "Of the triangles, in units of the shape")->capture_default_str();
  app.add_option("--repeat", request.repeat, "Runs, of which the median is shown")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--pictures", request.pictures, "A directory for what Open CASCADE draws, as SVG, and the shapes, as STEP");
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  fmt::print("{}\n\n", machine());
  fmt::print("| shape | chord | triangles | OCCT s | mesh s | hsr s | OCCT length | hsr length | difference | bound |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|\n");
  for (const ComparedShape& compared : compared_shapes())
    if (request.shapes.empty() || std::count(request.shapes.begin(), request.shapes.end(), compared.name) != 0)
      measure(compared, request);
  return 0;
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) try { return hsr::bench::run(argc, argv); } catch (const Standard_Failure& failure) {
  fmt::print(stderr, "surfaces: Open CASCADE failed: {}\n", failure.GetMessageString());
  return 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "surfaces: {}\n", error.what());
  return 1;
}
