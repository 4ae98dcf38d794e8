// lines: generates scenes, computes their visible lines and prints what that took. Nothing passes or fails by time.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/memory.h"
#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "geometry/error.h"
#include "geometry/mesh.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/view/view.h"

namespace hsr::bench {
namespace {

struct Request {
  std::vector<std::string> scenes, views;
  std::string edges = "all", csv, method = "automatic", stages = "automatic";
  int threads = 1, repeat = 3;
};

const std::map<std::string, LineMethod> methods = {
    {"automatic", LineMethod::automatic}, {"appel", LineMethod::appel}, {"roberts", LineMethod::roberts}};
const std::map<std::string, When> stages = {{"automatic", When::automatic}, {"always", When::always}, {"never", When::never}};

struct Row {
  std::string scene, view;
  std::size_t triangles = 0, edges = 0;
  Seconds mesh, lines, mesh_processor, lines_processor;
  std::uint64_t pairs = 0;
  DecisionCounts decisions;
  std::size_t visible = 0, hidden = 0;
  double megabytes = 0;
};

Row measure(const Model& model, const std::string& view_name, const Request& request) {
  Row row;
  row.scene = model.name;
  row.view = view_name;
  LineOptions options;
  if (request.edges == "all") options.classes.fill(true);
  options.method = methods.at(request.method);
  SceneOptions scene;
  scene.stages.fill(stages.at(request.stages));
  Times mesh_times, line_times;
  reset_peak_memory();
  for (int k = 0; k < request.repeat; ++k) {
    Mesh mesh;
    VisibleLines result;
    mesh_times.add(elapsed([&] { mesh = make_mesh(model.points, model.polygons); }));
    const View view = view_of(view_name, mesh);
    line_times.add(elapsed([&] { result = visible_lines(SceneView(mesh, view, scene), options); }));
    if (k > 0) continue;
    row.megabytes = peak_memory() / 1e6;
    row.triangles = mesh.triangles.size();
    row.edges = result.lines.size();
    row.pairs = result.pairs;
    row.decisions = result.decisions;
    for (const Line& line : result.lines)
      for (std::uint32_t i = 0; i < line.intervals(); ++i) ++(line.hidden(i) ? row.hidden : row.visible);
  }
  row.mesh = seconds(mesh_times.clock);
  row.mesh_processor = seconds(mesh_times.processor);
  row.lines = seconds(line_times.clock);
  row.lines_processor = seconds(line_times.processor);
  return row;
}

void print_row(const Row& row) {
  const auto& d = row.decisions;
  const double all = std::max(1.0, static_cast<double>(d.filter + d.interval + d.exact()));
  const auto share = [&](std::uint64_t n) { return fmt::format("{:.4g} %", 100 * static_cast<double>(n) / all); };
  fmt::print("| {} | {} | {} | {} | {:.3f} | {:.3f} ± {:.3f} | {:.3f} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n",
             row.scene, row.view, row.triangles, row.edges, row.mesh.median, row.lines.median, row.lines.spread,
             row.lines_processor.median, row.pairs, static_cast<std::uint64_t>(all), share(d.filter), share(d.interval),
             share(d.exact()), share(d.zero), row.visible, row.hidden, row.megabytes);
  std::fflush(stdout);
}

/// By how much the processor time grows with the number of triangles, from each size of a scene to the next: e in t ~ n^e, and
/// what e n log n has between the same sizes.
void print_growth(const std::vector<Row>& rows) {
  std::map<std::pair<std::string, std::string>, std::vector<const Row*>> series;
  for (const Row& row : rows) series[{family(row.scene), row.view}].push_back(&row);
  fmt::print(
      "\n| growth | view | from | to | e of mesh | e of lines | e of pairs | e of n log n "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (auto& [key, of_one] : series) {
    std::stable_sort(of_one.begin(), of_one.end(), [](const Row* a, const Row* b) { return a->triangles < b->triangles; });
    for (std::size_t k = 1; k < of_one.size(); ++k) {
      const Row &a = *of_one[k - 1], &b = *of_one[k];
      if (a.triangles == b.triangles) continue;
      const double m = static_cast<double>(a.triangles), n = static_cast<double>(b.triangles), decade = std::log(n / m);
      const auto exponent = [&](double from, double to) { return std::log(to / from) / decade; };
      fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", key.first, key.second, a.scene, b.scene,
                 exponent(a.mesh_processor.median, b.mesh_processor.median),
                 exponent(a.lines_processor.median, b.lines_processor.median),
                 exponent(static_cast<double>(a.pairs), static_cast<double>(b.pairs)),
                 exponent(m * std::log(m), n * std::log(n)));
    }
  }
}

void write_csv(const std::string& path, const std::vector<Row>& rows, const Request& request) {
  std::ofstream out(path);
  out << "scene,view,classes,threads,triangles,edges,mesh_seconds,lines_seconds,lines_spread,lines_processor_seconds,pairs,"
         "filter,interval,exact,zero,"
         "visible,hidden,peak_mb\n";
  for (const Row& r : rows)
    out << fmt::format("{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{},{},{},{},{},{:.1f}\n", r.scene, r.view,
                       request.edges, request.threads, r.triangles, r.edges, r.mesh.median, r.lines.median, r.lines.spread,
                       r.lines_processor.median, r.pairs, r.decisions.filter, r.decisions.interval, r.decisions.exact(),
                       r.decisions.zero, r.visible, r.hidden, r.megabytes);
  if (!out.flush()) throw InputError(path + ": cannot be written");
}

void run(const Request& request) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.threads));
  std::vector<Row> rows;
  fmt::print("{} edges, {} of {} threads, median and half the range of {}\n\n", request.edges, request.threads,
             std::thread::hardware_concurrency(), request.repeat);
  fmt::print(
      "| scene | view | triangles | edges | mesh s | lines s | processor s | pairs | signs | filter | interval | exact | zero "
      "| visible | "
      "hidden | peak MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : request.scenes) {
    const Model model = scene(name);
    for (const std::string& view : request.views) {
      rows.push_back(measure(model, view, request));
      print_row(rows.back());
    }
  }
  print_growth(rows);
  if (!request.csv.empty()) write_csv(request.csv, rows, request);
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  hsr::bench::Request request;
  CLI::App app{"Times, pairs and decisions of visible lines on generated scenes"};
  app.add_option("--scene", request.scenes,
                 "knot, city, rand, terrain, plate or quadplate and a size, as in knot100k; a city's is in boxes of 12, a "
                 "plate's in holes");
  app.add_option("--view", request.views, "oblique, elevation, perspective; default: all three");
  app.add_option("--edges", request.edges, "all, or default: all but smooth ones")->check(CLI::IsMember({"all", "default"}));
  app.add_option("--method", request.method, "automatic, appel or roberts")
      ->check(CLI::IsMember({"automatic", "appel", "roberts"}));
  app.add_option("--stages", request.stages, "what the plan leaves out: automatic, always or never")
      ->check(CLI::IsMember({"automatic", "always", "never"}));
  app.add_option("--threads", request.threads, "number of threads")->check(CLI::PositiveNumber);
  app.add_option("--repeat", request.repeat, "how often each is measured")->check(CLI::PositiveNumber);
  app.add_option("--csv", request.csv, "write the table to this file, too");
  CLI11_PARSE(app, argc, argv);
  if (request.scenes.empty())
    request.scenes = {"knot1k", "knot10k", "knot100k", "city100",   "city1k",     "city10k",
                      "rand1k", "rand10k", "rand100k", "terrain1k", "terrain10k", "terrain100k"};
  if (request.views.empty()) request.views = {"oblique", "elevation", "perspective"};
  try {
    hsr::bench::run(request);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
