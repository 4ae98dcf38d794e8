#include <fmt/core.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/sample_projection.h"
#include "hsr/raster/tiled_z_buffer.h"

// Seconds of each z-buffer, beside the simplest loop in floats that one would write by hand.

namespace hsr::bench {

using namespace internal;

namespace {

/// A row of a matrix: w . (x, y, z, 1).
using Row = std::array<float, 4>;
float at(const Row& r, const std::array<float, 3>& p) { return r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3]; }

/// The simplest z-buffer: a matrix of floats, and for each triangle all samples of its bounding box against three edge
/// functions, depth by their weights. No near plane, no clipping, no rule for samples on edges.
class SimplestZBuffer {
 public:
  SimplestZBuffer(const Mesh& mesh, const View& view, const SampleGrid& grid)
      : mesh_(mesh), width_(grid.width), height_(grid.height) {
    for (const Point3& p : mesh.points)
      points_.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    // x, y and nearness of a parallel view are linear, as is 1 over the depth: the rows are told by four points.
    const SampleProjection<double> project(view, grid);
    const double s = std::max({std::fabs(mesh.points[VertexId(0)].x), std::fabs(mesh.points[VertexId(0)].y),
                               std::fabs(mesh.points[VertexId(0)].z), 1.0});
    const std::array<Point3, 4> probes = {Point3{0, 0, 0}, Point3{s, 0, 0}, Point3{0, s, 0}, Point3{0, 0, s}};
    is_perspective_ = view.is_perspective();
    std::array<std::array<double, 4>, 4> values;  // by probe: x w, y w, 1, w with w = 1 / (nearness + 1), the depth
    for (std::size_t k = 0; k < 4; ++k) {
      const Seen<double> q = project(probes[k]);
      const double w = is_perspective_ ? 1 / (q.nearness + 1) : 1;
      values[k] = {q.x * w, q.y * w, is_perspective_ ? 1 : q.nearness, w};
    }
    for (std::size_t r = 0; r < 4; ++r)
      matrix_[r] = {static_cast<float>((values[1][r] - values[0][r]) / s),
                    static_cast<float>((values[2][r] - values[0][r]) / s),
                    static_cast<float>((values[3][r] - values[0][r]) / s), static_cast<float>(values[0][r])};
  }

  DepthImage<float> draw() const {
    DepthImage<float> image(width_, height_);
    std::vector<std::array<float, 3>> seen(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const auto& p = points_[v];
      const float w = 1 / at(matrix_[3], p);
      seen[v] = {at(matrix_[0], p) * w, at(matrix_[1], p) * w, at(matrix_[2], p) * w};
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& corners = mesh_.triangles[TriangleId(t)];
      const auto &a = seen[corners[0].value], &b = seen[corners[1].value], &c = seen[corners[2].value];
      const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      if (area == 0) continue;
      const int left = std::max(0, static_cast<int>(std::ceil(std::min({a[0], b[0], c[0]}))));
      const int right = std::min(width_ - 1, static_cast<int>(std::floor(std::max({a[0], b[0], c[0]}))));
      const int top = std::max(0, static_cast<int>(std::ceil(std::min({a[1], b[1], c[1]}))));
      const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(std::max({a[1], b[1], c[1]}))));
      for (int j = top; j <= bottom; ++j)
        for (int i = left; i <= right; ++i) {
          const float x = static_cast<float>(i), y = static_cast<float>(j);
          const float u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area;
          const float v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / area;
          const float w = 1 - u - v;
          if (u < 0 || v < 0 || w < 0) continue;
          const float nearness = u * a[2] + v * b[2] + w * c[2];
          DepthPixel<float>& pixel = image.at(i, j);
          if (nearness > pixel.nearness) pixel = {nearness, TriangleId(t)};
        }
    }
    return image;
  }

 private:
  const Mesh& mesh_;
  int width_, height_;
  bool is_perspective_ = false;
  std::vector<std::array<float, 3>> points_;
  std::array<Row, 4> matrix_;
};

int run(int argc, char** argv) {
  std::vector<std::string> scenes = {"knot100k", "knot1M", "city10k"};
  std::string view_name = "oblique";
  int size = 1024, threads = 1, runs = 9;
  CLI::App app{"Times of z-buffers"};
  app.add_option("scene", scenes, "as of write_scene");
  app.add_option("--view", view_name, "oblique, elevation or perspective");
  app.add_option("--size", size, "samples each way");
  app.add_option("--threads", threads);
  app.add_option("--runs", runs, "medians of these, in turn");
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));

  for (const std::string& name : scenes) {
    const Model model = scene(name);
    const Mesh mesh = make_mesh(model.points, model.polygons);
    const View view = view_of(view_name, mesh);
    const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), size, size);
    const SimplestZBuffer simplest(mesh, view, grid);
    struct Way {
      const char* name;
      std::function<void()> draw;
      Times times;
    };
    DepthImage<float> by_hand, plain;
    std::size_t row_bytes = 0, tile_bytes = 0;
    std::vector<Way> ways = {{"simplest loop, float", [&] { by_hand = simplest.draw(); }, {}},
                             {"z-buffer, float", [&] { plain = z_buffer<float>(mesh, view, grid); }, {}},
                             {"z-buffer, double", [&] { (void)z_buffer<double>(mesh, view, grid); }, {}},
                             {"row z-buffer, float", [&] { row_bytes = row_z_buffer<float>(mesh, view, grid).bytes; }, {}},
                             {"tiled z-buffer, float", [&] { tile_bytes = tiled_z_buffer<float>(mesh, view, grid).bytes; }, {}},
                             {"tiled z-buffer, double", [&] { (void)tiled_z_buffer<double>(mesh, view, grid); }, {}}};
    for (int r = 0; r < runs; ++r)
      for (Way& way : ways) way.times.add(elapsed(way.draw));
    std::size_t different = 0;
    for (std::size_t k = 0; k < plain.pixels.size(); ++k)
      different += plain.pixels[k].triangle != by_hand.pixels[k].triangle ? 1U : 0U;
    fmt::print("{} {} {}x{}: {} triangles, {} thread(s); {} samples differ from the simplest loop's; bytes: row {}, tiles {}\n",
               name, view_name, size, size, mesh.triangles.size(), threads, different, row_bytes, tile_bytes);
    const double first = seconds(ways.front().times.processor).median, first_clock = seconds(ways.front().times.clock).median;
    for (const Way& way : ways) {
      const Seconds s = seconds(way.times.processor), clock = seconds(way.times.clock);
      fmt::print("  {:<24} processors {:7.2f} ms +- {:5.2f}, {:5.2f} times as fast; clock {:7.2f} ms, {:5.2f}\n", way.name,
                 1000 * s.median, 1000 * s.spread, first / s.median, 1000 * clock.median, first_clock / clock.median);
    }
  }
  return 0;
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) { return hsr::bench::run(argc, argv); }
