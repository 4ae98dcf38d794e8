#include <fmt/core.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/peer.h"
#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/rasterizer.h"
#include "hsr/raster/z_buffer.h"

// Seconds of each way to make a picture of samples, on one scene.

namespace hsr::bench {

using namespace internal;

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
  const auto print = [](const char* name, const Elapsed& time) {
    fmt::print("{:<22} {:8.3f} s by the clock, {:8.3f} s of processors\n", name, time.clock, time.processor);
  };
  fmt::print("{} {} {}x{}: {} triangles\n", scene_name, view_name, size, size, mesh.triangles.size());

  CastImage image;
  print("cast", elapsed([&] { image = cast(mesh, view, grid); }));
  const auto covered =
      std::count_if(image.triangles.pixels.begin(), image.triangles.pixels.end(), [](TriangleId t) { return t.is_valid(); });
  const DecisionCounts& d = image.decisions;
  fmt::print("  {} samples covered; interval {} exact {} zero {}\n", covered, d.interval, d.exact(), d.zero);

  const auto agreement = [&](const auto& z) {
    std::size_t different = 0;
    for (std::size_t k = 0; k < z.pixels.size(); ++k) different += z.pixels[k].triangle != image.triangles.pixels[k] ? 1U : 0U;
    fmt::print("  {} samples differ from cast\n", different);
  };
  DepthImage<float> single;
  print("z-buffer float", elapsed([&] { single = z_buffer<float>(mesh, view, grid); }));
  agreement(single);
  single = {};
  DepthImage<double> twice;
  print("z-buffer double", elapsed([&] { twice = z_buffer<double>(mesh, view, grid); }));
  agreement(twice);
  twice = {};

  // All triangles in file order, one thread: what painting costs, not a picture.
  std::size_t painted = 0;
  Image<TriangleId> picture;
  std::optional<ProjectedMesh> projected;
  print("sight", elapsed([&] { projected.emplace(mesh, view, Arithmetic::staged, grid.bit_range()); }));
  print("rasterizer", elapsed([&] {
          const SampleSigns signs(*projected, grid);
          Rasterizer rasterizer(signs);
          picture = Image<TriangleId>(size, size);
          for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto spans = rasterizer.spans(TriangleId(t));
            Rasterizer::paint(picture, spans, TriangleId(t));
            for (const SampleSpan& s : spans) painted += static_cast<std::size_t>(s.end - s.begin);
          }
        }));
  fmt::print("  {} samples painted\n", painted);
  print("rasterizer, by sides", elapsed([&] {
          const SampleSigns signs(*projected, grid);
          Rasterizer rasterizer(signs);
          std::vector<RasterSide> sides;
          for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            sides.clear();
            rasterizer.append_sides(TriangleId(t), sides);
            Rasterizer::paint(picture, rasterizer.spans(sides), TriangleId(t));
          }
        }));
  if (size == 4096) {
    const Task task{model, mesh, view, {}};
    print("peers z-buffer", z_buffer_4096(task).compute);
  }
  return 0;
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) { return hsr::bench::run(argc, argv); }
