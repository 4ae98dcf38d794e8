// fragments: generates scenes, computes their visible fragments and prints what that took. Nothing passes or fails by time.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "bench/memory.h"
#include "bench/peers/envelope.h"
#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "geometry/mesh.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

namespace hsr::bench {

using namespace internal;

namespace {

struct Request {
  std::vector<std::string> scenes, views;
  std::string method = "visible";
  bool envelope = false;
  int threads = 1, repeat = 3;
};

void measure(const Model& model, const std::string& view_name, const Request& request) {
  const Mesh mesh = make_mesh(model.points, model.polygons);
  const View view = view_of(view_name, mesh);
  Times times;
  VisibleFragments found;
  reset_peak_memory();
  for (int k = 0; k < request.repeat; ++k)
    times.add(
        elapsed([&] { found = request.method == "roberts" ? roberts_surfaces(mesh, view) : visible_fragments(mesh, view); }));
  const Seconds clock = seconds(times.clock), processor = seconds(times.processor);
  const DecisionCounts& d = found.decisions;
  const double all = std::max(1.0, static_cast<double>(d.all()));
  fmt::print("| {} | {} | {} | {:.3f} ± {:.3f} | {:.3f} | {} | {} | {} | {} | {:.4g} % | {:.4g} % | {:.0f} |\n", model.name,
             view_name, mesh.triangles.size(), clock.median, clock.spread, processor.median, found.fragments.size(),
             found.rings.size(), found.rings.values().size(), d.all(), 100 * static_cast<double>(d.filter) / all,
             100 * static_cast<double>(d.zero) / all, peak_memory() / 1e6);
  if (request.envelope && !view.is_perspective()) {
    const Envelope peer = envelope(mesh, view, false);
    fmt::print("| CGAL envelope of {} | {} | {} | {:.3f} | | {} regions, {:.0f} times as long | | | | | | |\n", model.name,
               view_name, mesh.triangles.size(), peer.compute, peer.regions, peer.compute / clock.median);
  }
  std::fflush(stdout);
}

void run(const Request& request) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.threads));
  fmt::print("{} of {} threads, median and half the range of {}\n\n", request.threads, std::thread::hardware_concurrency(),
             request.repeat);
  fmt::print(
      "| scene | view | triangles | fragments s | processor s | fragments | rings | corners | signs | filter | zero | peak MB "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : request.scenes) {
    const Model model = scene(name);
    for (const std::string& view : request.views) measure(model, view, request);
  }
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  hsr::bench::Request request;
  CLI::App app{"Times and decisions of visible fragments on generated scenes"};
  app.add_option("--scene", request.scenes,
                 "knot, city, rand, terrain, plate or quadplate and a size, as in knot100k; a city's is in boxes of 12, a "
                 "plate's in holes");
  app.add_option("--view", request.views, "oblique, elevation, perspective; default: all three");
  app.add_option("--method", request.method, "visible, or the reference: roberts")
      ->check(CLI::IsMember({"visible", "roberts"}));
  app.add_flag("--envelope", request.envelope, "CGAL's envelope of the same triangles, too, in parallel views");
  app.add_option("--threads", request.threads, "number of threads")->check(CLI::PositiveNumber);
  app.add_option("--repeat", request.repeat, "how often each is measured")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  if (request.scenes.empty())
    request.scenes = {"knot1k",  "knot10k", "knot100k", "city100",    "city1k",
                      "city10k", "rand1k",  "rand10k",  "terrain10k", "terrain100k"};
  if (request.views.empty()) request.views = {"oblique", "elevation", "perspective"};
  try {
    hsr::bench::run(request);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
