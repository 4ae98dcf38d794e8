#include <fmt/core.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "hsr/image/caster.h"

// Seconds of each way to make a picture of samples, on one scene.

namespace hsr::bench {
namespace {

int run(int argc, char** argv) {
  std::string scene_name = "knot1M", view_name = "oblique";
  int size = 4096, threads = 2;
  CLI::App app{"Times of pictures of samples"};
  app.add_option("scene", scene_name, "as of write_scene");
  app.add_option("--view", view_name, "oblique, elevation or perspective");
  app.add_option("--size", size, "samples each way");
  app.add_option("--threads", threads);
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));

  const Model model = scene(scene_name);
  const Mesh mesh = make_mesh(model.points, model.polygons);
  const View view = view_of(view_name, mesh);
  const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), size, size);
  CastImage image;
  const Elapsed cast_time = elapsed([&] { image = cast(mesh, view, grid); });
  const auto covered =
      std::count_if(image.triangles.pixels.begin(), image.triangles.pixels.end(), [](TriangleId t) { return t.is_valid(); });
  fmt::print("{} {} {}x{}: {} triangles, {} samples covered\n", scene_name, view_name, size, size, mesh.triangles.size(),
             covered);
  const DecisionCounts& d = image.decisions;
  fmt::print("cast      {:8.3f} s by the clock, {:8.3f} s of processors; interval {} exact {} zero {}\n", cast_time.clock,
             cast_time.processor, d.interval, d.exact(), d.zero);
  return 0;
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) { return hsr::bench::run(argc, argv); }
