// models: visible lines of every model in a folder by each method, one row each; says where two methods disagree (exit status
// 1).
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/seconds.h"
#include "bench/views.h"
#include "geometry/error.h"
#include "hsr/io/read/read.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::bench {
namespace {

struct Request {
  std::string folder;
  std::vector<std::string> views = {"oblique"};
  std::string edges = "all";
  std::size_t most = 1000000;
  int threads = 2;
};

/// How two results differ; empty: the same edges, classes and intervals, to the bit.
std::string difference(const Mesh& mesh, const View& view, const VisibleLines& x, const VisibleLines& y) {
  if (x.lines.size() != y.lines.size()) return fmt::format("{} lines against {}", x.lines.size(), y.lines.size());
  for (std::size_t i = 0; i < x.lines.size(); ++i) {
    const Line &a = x.lines[i], &b = y.lines[i];
    const SupportingLine support = supporting_line_of(mesh, x, a);
    const std::string where = support.is_edge()
                                  ? fmt::format("edge {} {}: ", support.a.value, support.b.value)
                                  : fmt::format("triangles {} x {}: ", support.meet.s.value, support.meet.t.value);
    if (a.edge != b.edge || a.intersection != b.intersection || a.edge_class != b.edge_class)
      return where + "another edge or class";
    if (a.intervals() != b.intervals()) return where + fmt::format("{} intervals against {}", a.intervals(), b.intervals());
    if (a.intervals() > 0 && a.starts_hidden != b.starts_hidden) return where + "starts hidden, or not";
    for (std::size_t k = 0; k < x.cuts_of(a).size(); ++k) {
      const Cut &c = x.cuts_of(a)[k], &d = y.cuts_of(b)[k];
      if (!(c == d) && !(exact_parameter(mesh, view, support, c) == exact_parameter(mesh, view, support, d)))
        return where + "another parameter";
    }
  }
  return {};
}

/// @returns whether the methods agree
bool row(const std::filesystem::path& file, const std::string& view_name, const Request& request) {
  Model model;
  Mesh mesh;
  double reading = 0, meshing = 0;
  try {
    reading = elapsed([&] { model = read_model(file.string()); }).clock;
    meshing = elapsed([&] { mesh = make_mesh(model.points, model.polygons); }).clock;
  } catch (const InputError&) {
    return true;  // not a model
  }
  if (mesh.edges.empty() || mesh.triangles.size() > request.most) return true;
  const View view = view_of(view_name, mesh);
  VisibleLines found[3];
  double seconds[3];
  for (std::size_t k = 0; k < 3; ++k) {
    LineOptions options;
    if (request.edges == "all") options.classes.fill(true);
    options.method = k == 0 ? LineMethod::automatic : k == 1 ? LineMethod::appel : LineMethod::roberts;
    SceneOptions scene;
    if (k == 2) scene.stages.fill(When::never);
    seconds[k] = elapsed([&] { found[k] = visible_lines(SceneView(mesh, view, scene), options); }).clock;
  }
  std::string wrong = difference(mesh, view, found[1], found[2]);
  if (wrong.empty()) wrong = difference(mesh, view, found[0], found[2]);
  fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} ({}) | {:.3f} | {:.3f} | {:.2f} | {} |\n", file.filename().string(),
             view_name, mesh.triangles.size(), reading, meshing, seconds[0], found[0].plan.method, seconds[1], seconds[2],
             1e6 * seconds[0] / static_cast<double>(std::max<std::size_t>(1, mesh.triangles.size())),
             wrong.empty() ? "yes" : wrong);
  std::fflush(stdout);
  return wrong.empty();
}

bool run(const Request& request) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.threads));
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(request.folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  fmt::print("| model | view | triangles | read s | mesh s | lines s | appel s | roberts s | us per triangle | agree |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|\n");
  bool agree = true;
  for (const auto& file : files)
    for (const std::string& view : request.views) agree = row(file, view, request) && agree;
  return agree;
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  hsr::bench::Request request;
  CLI::App app{"Visible lines of every model in a folder, by each method, and whether they agree"};
  app.add_option("FOLDER", request.folder, "searched with all its folders")->required()->check(CLI::ExistingDirectory);
  app.add_option("--view", request.views, "oblique, elevation, perspective [oblique]");
  app.add_option("--edges", request.edges, "all, or default: all but smooth ones")->check(CLI::IsMember({"all", "default"}));
  app.add_option("--most", request.most, "leave out models of more triangles");
  app.add_option("--threads", request.threads, "number of threads")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    return hsr::bench::run(request) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
