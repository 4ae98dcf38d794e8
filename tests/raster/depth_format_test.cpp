#include "hsr/raster/depth_format.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"
#include "hsr/raster/depth_buffer.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using namespace internal;

namespace {

/// Two squares that face a viewer at the origin who looks along -z, the farther one first; all samples see both.
DepthBuffer two_squares(double z, double gap, double near, double far, DepthFormat format) {
  scenes::TestScene scene;
  for (const double d : {z + gap, z}) {
    const double r = 2 * z;
    scene.add_face(std::vector<Point3>{{-r, -r, -d}, {r, -r, -d}, {r, r, -d}, {-r, r, -d}});
  }
  const Mesh mesh = scene.mesh();
  const View view = perspective_view({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, near / 2);
  // Samples on |x|, |y| < 1/2 of the plane z = -1: within both squares.
  const SampleGrid grid = {{-0.4375, 0.4375, -1}, {0.0625, 0, 0}, {0, -0.0625, 0}, 15, 15};
  return depth_buffer(mesh, view, grid, depth_range(view, grid, near, far), {.format = format});
}

bool tells_apart(double z, double gap, double near, double far, DepthFormat format) {
  const DepthBuffer buffer = two_squares(z, gap, near, far, format);
  // The nearer square is the second face: triangles 2 and 3.
  return std::all_of(buffer.triangles.pixels.begin(), buffer.triangles.pixels.end(),
                     [](TriangleId t) { return t.is_valid() && t.value >= 2; });
}

TEST_CASE("the lecture's compression: z' for n = 0.1 and f = 1", "[image][depth_format][lecture]") {
  CHECK(transformed_depth(-0.1, 0.1, 1) == 0);
  CHECK(transformed_depth(-1, 0.1, 1) == -1);
  CHECK(transformed_depth(-0.5, 0.1, 1) == Approx(-8.0 / 9).epsilon(1e-15));
  // Nearly half of the range is spent on the tenth of the volume next to the near plane ...
  CHECK(transformed_depth(-0.19, 0.1, 1) == Approx(-10.0 / 19).epsilon(1e-14));
  // ... and a ninetieth on the tenth next to the far plane.
  CHECK(transformed_depth(-1, 0.1, 1) - transformed_depth(-0.91, 0.1, 1) == Approx(-1.0 / 91).epsilon(1e-13));
}

TEST_CASE("the depth of a range is the classical one", "[image][depth_format]") {
  const View view = perspective_view({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.05);
  const SampleGrid grid = {{-0.5, 0.5, -1}, {0.0625, 0, 0}, {0, -0.0625, 0}, 16, 16};
  const DepthRange range = depth_range(view, grid, 0.1, 1);
  CHECK(range.near_distance() == Approx(0.1).epsilon(1e-14));
  CHECK(1 / (range.far + 1) == Approx(1).epsilon(1e-14));
  for (const double z : {0.1, 0.19, 0.25, 0.5, 0.75, 0.91, 1.0})
    CHECK(range.depth(1 / z - 1) == Approx(-transformed_depth(-z, 0.1, 1)).margin(1e-14));
  CHECK_THROWS_AS(depth_range(view, grid, 1, 1), InputError);
  CHECK_THROWS_AS(depth_range(view, grid, 0, 1), InputError);
  CHECK_THROWS_AS(depth_range(parallel_view({0, 0, 1}, {0, 1, 0}), grid, 0.1, 1), InputError);
}

TEST_CASE("each format tells apart what theory says, and not a sixteenth of it", "[image][depth_format][property]") {
  constexpr double near = 0.1, far = 10000;
  for (const DepthFormat format : depth_formats)
    for (const double z : {1.0, 10.0, 100.0, 1000.0}) {
      const double gap = smallest_gap(format, z, near, far);
      INFO(name(format) << " at " << z << ": " << gap);
      if (32 * gap > z) continue;  // the slope is no longer that at z
      // Two roundings to the step, and the arithmetic of floats: a few steps.
      int apart = 0;
      for (int k = 0; k < 8; ++k) {
        const double at = z * (1 + k / 64.0);
        CHECK(tells_apart(at, 8 * gap, near, far, format));
        apart += tells_apart(at, gap / 16, near, far, format) ? 1 : 0;
      }
      // Two numbers that near are the same but where a rounding falls between them.
      CHECK(apart <= 4);
    }
}

TEST_CASE("where distances are beyond all doubles a logarithmic buffer has a step without end", "[image][depth_format]") {
  const DepthRange range{1, -1, true};  // nearness -1: at infinity
  CHECK(step(DepthFormat::logarithmic_float32, range, -1) == HUGE_VAL);
  CHECK(step(DepthFormat::logarithmic_float32, range, 0.5) == HUGE_VAL);
  CHECK(std::isfinite(step(DepthFormat::logarithmic_float32, {1, -0.5, true}, 0.5)));
}

TEST_CASE("more near, more bits and a reversed buffer buy what they should", "[image][depth_format]") {
  CHECK(smallest_gap(DepthFormat::fixed24, 100, 0.1, 1e4) == Approx(100.0 * 100 / (0.1 * 0x1p24)).epsilon(1e-3));
  CHECK(smallest_gap(DepthFormat::fixed24, 100, 1, 1e4) ==
        Approx(smallest_gap(DepthFormat::fixed24, 100, 0.1, 1e4) / 10).epsilon(1e-3));
  CHECK(smallest_gap(DepthFormat::fixed32, 100, 0.1, 1e4) ==
        Approx(smallest_gap(DepthFormat::fixed24, 100, 0.1, 1e4) / 256).epsilon(1e-6));
  CHECK(smallest_gap(DepthFormat::reversed_float32, 100, 0.1, 1e4) < smallest_gap(DepthFormat::float32, 100, 0.1, 1e4) / 400);
}

}  // namespace
}  // namespace hsr
