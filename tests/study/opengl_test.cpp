#include <catch2/catch.hpp>

#include "hsr/check/picture_check.h"
#include "hsr/raster/caster.h"
#include "study/compared_methods.h"
#include "study/opengl_buffer.h"
#include "tests/scenes/random_scenes.h"

namespace hsr::internal {
namespace {

Mesh mesh_of(const std::vector<Point3>& points) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t k = 0; k + 2 < points.size(); k += 3) triangles.push_back({k, k + 1, k + 2});
  return make_mesh(points, triangles);
}

/// Null, and a word on it, where there is no driver: then there is nothing to test.
std::unique_ptr<OpenGl> driver() {
  std::unique_ptr<OpenGl> gl = OpenGl::make();
  if (gl == nullptr) WARN("no OpenGL: " << OpenGl::why());
  return gl;
}

TEST_CASE("the driver shows the nearest face where its numbers tell", "[study][opengl]") {
  const auto gl = driver();
  if (gl == nullptr) return;
  // Two triangles that lean through each other, in a parallel view and in a perspective.
  const Mesh mesh = mesh_of({{-2, -2, -2}, {2, -2, 2}, {0, 3, 0}, {-2, -2, 2}, {2, -2, -2}, {0, 3, 0}});
  for (const View& view : {scenes::from_direction({0, 0, 1}), scenes::from_eye({0, 0, 9}, {0, 0, 0})}) {
    const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 64, 64);
    const Image<TriangleId> nearest = cast(mesh, view, grid).triangles;
    const DepthRange range = depth_range(mesh, view, grid);
    for (const DepthFormat format :
         {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::float32, DepthFormat::reversed_float32}) {
      const Image<TriangleId> image = gl->draw(mesh, view, grid, range, {.format = format});
      const DepthResolution resolution{format, range, std::ldexp(1.0, -gl->subpixel_bits())};
      const PictureCheck check = check_picture(mesh, view, grid, image, nearest, resolution);
      CHECK(check.covered > 1000);
      CHECK(check.order == 0);   // every difference is explained
      CHECK(check.wrong < 140);  // and they are on edges, and where the two meet
    }
  }
}

TEST_CASE("every difference of the driver is explained on random scenes", "[study][opengl][property]") {
  if (opengl_driver() == nullptr) return;
  std::uint64_t wrong = 0;
  for (const char* const name : {"triangles", "polygons", "boxes", "slopes"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const scenes::TestScene scene = scenes::family(name).make(seed);
      const Mesh mesh = scene.mesh();
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 240, 240);
      const Image<TriangleId> nearest = cast(mesh, scene.view, grid).triangles;
      for (const RunnableMethod& m : opengl_methods(mesh, scene.view, grid)) {
        INFO(name << " " << seed << ", " << m.method << ", " << m.numbers);
        m.solve();
        const PictureCheck check = check_picture(mesh, scene.view, grid, m.show().triangles, nearest, m.resolution);
        CHECK(check.order == 0);
        wrong += check.wrong;
      }
    }
  CHECK(wrong > 0);
}

TEST_CASE("16 bits tie what 24 tell apart, in the driver too", "[study][opengl]") {
  const auto gl = driver();
  if (gl == nullptr) return;
  // The nearer one second: with a tie the first stays. A third one makes room for the range.
  const double gap = 1e-6;
  const Mesh mesh =
      mesh_of({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, gap}, {8, 0, gap}, {0, 8, gap}, {-9, -9, 1}, {-8, -9, 1}, {-9, -8, 1}});
  const View view = scenes::from_direction({0, 0, 1});
  const SampleGrid grid{{1, 1, 0}, {0.25, 0, 0}, {0, 0.25, 0}, 8, 8};
  const DepthRange range = depth_range(mesh, view, grid);
  const auto shown = [&](DepthFormat format) { return gl->draw(mesh, view, grid, range, {.format = format}).at(2, 2).value; };
  CHECK(shown(DepthFormat::fixed16) == 0);
  CHECK(shown(DepthFormat::fixed24) == 1);
  CHECK_THROWS_WITH(shown(DepthFormat::fixed8), Catch::Contains("expected fixed 16"));
}

TEST_CASE("of coincident triangles the driver shows the one on top, and polygon offset moves one forward", "[study][opengl]") {
  const auto gl = driver();
  if (gl == nullptr) return;
  const Mesh mesh =
      mesh_of({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {-9, -9, 1}, {-8, -9, 1}, {-9, -8, 1}});
  const View view = scenes::from_direction({0, 0, 1});
  const SampleGrid grid{{1, 1, 0}, {0.25, 0, 0}, {0, 0.25, 0}, 8, 8};
  const DepthRange range = depth_range(mesh, view, grid);
  const auto shown = [&](const OpenGlOptions& options) { return gl->draw(mesh, view, grid, range, options).at(2, 2).value; };
  CHECK(shown({}) == 0);
  CHECK(shown({.ties = Coplanar::last}) == 1);
  CHECK(shown({.offset_units = -4, .offset_from = 1}) == 1);
  CHECK(shown({.offset_units = 4, .offset_from = 1}) == 0);
}

TEST_CASE("what is before the near plane is not drawn", "[study][opengl]") {
  const auto gl = driver();
  if (gl == nullptr) return;
  const Mesh mesh = mesh_of({{-1, -1, 4.5}, {1, -1, 4.5}, {0, 1, 4.5}, {-4, -4, 0}, {4, -4, 0}, {0, 4, 0}});
  const View view = scenes::from_eye({0, 0, 5}, {0, 0, 0}, 0.5);
  const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 16, 16);
  const Image<TriangleId> image = gl->draw(mesh, view, grid, depth_range(mesh, view, grid), {});
  CHECK(image.at(8, 9).value == 1);
}

}  // namespace
}  // namespace hsr::internal
