#include "hsr/raster/depth_buffer.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"
#include "hsr/raster/z_buffer.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// Seen from above on a grid of whole numbers; depths 0 ... 255 are heights 0 ... -255, so an 8-bit buffer holds them as they
/// are.
struct Lecture {
  scenes::TestScene scene;
  SampleGrid grid;
  DepthRange range{0, -255, false};

  Lecture(int width, int height) : grid{{0.5, -0.5, 0}, {1, 0, 0}, {0, -1, 0}, width, height} {
    scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  }
  /// Corners: column, row and depth.
  void add(const std::vector<std::array<double, 3>>& corners) {
    std::vector<Point3> points;
    for (const auto& [x, y, depth] : corners) points.push_back({x, -y, -depth});
    scene.add_face(points);
  }
  DepthBuffer drawn(const DepthBufferOptions& options) const {
    return depth_buffer(scene.mesh(), scene.view, grid, range, options);
  }
  std::vector<std::vector<int>> depths(DepthBufferOptions options = {.format = DepthFormat::fixed8}) const {
    const DepthBuffer buffer = drawn(options);
    std::vector<std::vector<int>> rows;
    for (int j = 0; j < grid.height; ++j) {
      rows.emplace_back();
      for (int i = 0; i < grid.width; ++i) rows.back().push_back(static_cast<int>(std::lround(buffer.depths.at(i, j) * 255)));
    }
    return rows;
  }
};

using Rows = std::vector<std::vector<int>>;

TEST_CASE("the lecture's buffer of whole numbers: near 0, far 255, triangles of depth 64 and 127", "[image][lecture]") {
  Lecture lecture(5, 5);
  lecture.add({{0, 0, 64}, {5, 0, 64}, {0, 5, 64}});
  CHECK(lecture.depths() == Rows{{64, 64, 64, 64, 255},
                                 {64, 64, 64, 255, 255},
                                 {64, 64, 255, 255, 255},
                                 {64, 255, 255, 255, 255},
                                 {255, 255, 255, 255, 255}});
  lecture.add({{5, 0, 127}, {5, 5, 127}, {0, 0, 127}});
  const Rows both = {{64, 64, 64, 64, 127},
                     {64, 64, 64, 127, 127},
                     {64, 64, 127, 127, 127},
                     {64, 255, 255, 127, 127},
                     {255, 255, 255, 255, 127}};
  CHECK(lecture.depths() == both);
  SECTION("in the other order it is the same") {
    Lecture other(5, 5);
    other.add({{5, 0, 127}, {5, 5, 127}, {0, 0, 127}});
    other.add({{0, 0, 64}, {5, 0, 64}, {0, 5, 64}});
    CHECK(other.depths() == both);
  }
}

TEST_CASE("the lecture's buffer of 64s, a triangle of 5s, and one from 2 to 7 that pierces it", "[image][lecture]") {
  Lecture lecture(8, 8);
  lecture.range = {0, -64, false};
  const auto depths = [&] {
    const DepthBuffer buffer = lecture.drawn({.format = DepthFormat::fixed16});
    Rows rows;
    for (int j = 0; j < 8; ++j) {
      rows.emplace_back();
      for (int i = 0; i < 8; ++i) rows.back().push_back(static_cast<int>(std::lround(buffer.depths.at(i, j) * 64)));
    }
    return rows;
  };
  lecture.add({{0, 0, 5}, {8, 0, 5}, {0, 8, 5}});
  CHECK(depths()[0] == std::vector<int>{5, 5, 5, 5, 5, 5, 5, 64});
  CHECK(depths()[6] == std::vector<int>{5, 64, 64, 64, 64, 64, 64, 64});
  // Depth at sample (i, j), i and j from 0: 8 + i - j; rows 1 ... 6 have 1 ... 6 samples.
  lecture.add({{0, 0.75, 7.25}, {0, 7, 1}, {6.25, 7, 7.25}});
  CHECK(depths() == Rows{{5, 5, 5, 5, 5, 5, 5, 64},
                         {5, 5, 5, 5, 5, 5, 64, 64},
                         {5, 5, 5, 5, 5, 64, 64, 64},
                         {5, 5, 5, 5, 64, 64, 64, 64},
                         {4, 5, 5, 7, 64, 64, 64, 64},
                         {3, 4, 5, 6, 7, 64, 64, 64},
                         {2, 3, 4, 5, 6, 7, 64, 64},
                         {64, 64, 64, 64, 64, 64, 64, 64}});
}

TEST_CASE("three triangles at depths 0.5, 0.75 and 0.25, in any order", "[image][lecture]") {
  std::array<double, 3> order = {0.25, 0.5, 0.75};
  do {
    Lecture lecture(4, 4);
    lecture.range = {0, -1, false};
    for (const double depth : order) lecture.add({{0, 0, depth}, {8, 0, depth}, {0, 8, depth}});
    for (const DepthFormat format : {DepthFormat::fixed24, DepthFormat::float32, DepthFormat::reversed_float32}) {
      const DepthBuffer buffer = lecture.drawn({.format = format});
      CHECK(order[buffer.triangles.at(1, 1).value] == 0.25);
      CHECK(buffer.depths.at(1, 1) == Approx(0.25).margin(0x1p-23));
      const DepthBuffer farthest = lecture.drawn({.format = format, .function = DepthFunction::greater});
      CHECK(order[farthest.triangles.at(1, 1).value] == 0.75);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("the eight depth functions", "[image][depth_buffer]") {
  // Depths 100, 50, 50, 200 in this order on all samples.
  Lecture lecture(4, 4);
  for (const double depth : {100, 50, 50, 200}) lecture.add({{0, 0, depth}, {8, 0, depth}, {0, 8, depth}});
  const auto shown = [&](DepthFunction function) -> int {
    const TriangleId t = lecture.drawn({.format = DepthFormat::fixed8, .function = function}).triangles.at(1, 1);
    return t.is_valid() ? static_cast<int>(t.value) : -1;
  };
  CHECK(shown(DepthFunction::never) == -1);
  CHECK(shown(DepthFunction::less) == 1);
  CHECK(shown(DepthFunction::lequal) == 2);
  CHECK(shown(DepthFunction::equal) == -1);    // nothing is at 255
  CHECK(shown(DepthFunction::notequal) == 3);  // 100, 50, (50 is equal), 200
  CHECK(shown(DepthFunction::greater) == 3);
  CHECK(shown(DepthFunction::gequal) == 3);
  CHECK(shown(DepthFunction::always) == 3);
}

TEST_CASE("a bias decides between faces in one plane", "[image][depth_buffer]") {
  Lecture lecture(4, 4);
  lecture.add({{0, 0, 10}, {8, 0, 20}, {0, 8, 30}});
  for (const DepthFormat format :
       {DepthFormat::fixed16, DepthFormat::fixed32, DepthFormat::float32, DepthFormat::float64, DepthFormat::reversed_float32})
    for (const double bias : {-2.0, 0.0, 2.0}) {
      const DepthBuffer plain = lecture.drawn({.format = format}), moved = lecture.drawn({.format = format, .bias = bias});
      INFO(name(format) << " " << bias);
      const double change = moved.depths.at(1, 1) - plain.depths.at(1, 1);
      CHECK((bias < 0 ? change < 0 : bias > 0 ? change > 0 : change == 0));
      const DepthBuffer steep = lecture.drawn({.format = format, .slope_bias = bias});
      CHECK(steep.depths.at(1, 1) - plain.depths.at(1, 1) == Approx(bias * 2.5 / 255).margin(0x1p-14));
    }
}

TEST_CASE("depths before the near and beyond the far plane are not drawn", "[image][depth_buffer]") {
  Lecture lecture(8, 1);
  lecture.add({{0, 0, -40}, {8, 0, 280}, {8, 8, 280}, {0, 8, -40}});  // 40 a column: -20, 20, 60, ... 260
  for (const DepthFormat format :
       {DepthFormat::fixed8, DepthFormat::fixed24, DepthFormat::float32, DepthFormat::float64, DepthFormat::reversed_float32}) {
    const DepthBuffer buffer = lecture.drawn({.format = format});
    for (int i = 0; i < 8; ++i) CHECK(buffer.triangles.at(i, 0).is_valid() == (i > 0 && i < 7));
    CHECK(buffer.depths.at(1, 0) == Approx(20.0 / 255).margin(0x1p-10));
  }
  CHECK_THROWS_AS(lecture.drawn({.format = DepthFormat::logarithmic_float32}), InputError);
}

/// Doubles by either way of interpolation, and by z_buffer(), show the same but next to edges and ties.
TEST_CASE("all interpolations and wide formats agree with the plain z-buffer nearly everywhere", "[image][depth_buffer]") {
  std::size_t samples = 0, different = 0;
  for (const char* family : {"triangles", "polygons", "boxes", "around_the_eye"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      const Mesh mesh = scene.mesh();
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
      const DepthImage<double> plain = z_buffer<double>(mesh, scene.view, grid);
      const DepthRange range = depth_range(mesh, scene.view, grid);
      for (const DepthInterpolation interpolation :
           {DepthInterpolation::plane, DepthInterpolation::incremental, DepthInterpolation::barycentric})
        for (const DepthFormat format : {DepthFormat::float64, DepthFormat::fixed32}) {
          const DepthBuffer buffer =
              depth_buffer(mesh, scene.view, grid, range, {.format = format, .interpolation = interpolation});
          std::size_t wrong = 0;
          for (std::size_t k = 0; k < plain.pixels.size(); ++k) {
            const bool differs = buffer.triangles.pixels[k] != plain.pixels[k].triangle;
            // Faces in one plane: either may be shown.
            const double depth = plain.pixels[k].triangle.is_valid() ? range.depth(plain.pixels[k].nearness) : 1;
            if (differs && std::fabs(buffer.depths.pixels[k] - depth) > 0x1p-20) ++wrong;
          }
          samples += plain.pixels.size();
          different += wrong;
        }
    }
  CAPTURE(samples, different);
  CHECK(different < samples / 500);  // samples exactly on edges
}

}  // namespace
}  // namespace hsr
