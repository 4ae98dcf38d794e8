#include "hsr/check/picture_check.h"

#include <catch2/catch.hpp>

#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// Three squares over each other at heights 0, 1 and 1 + 2^-20, seen from above; the uppermost covers the left half.
struct Stack {
  scenes::TestScene scene;
  SampleGrid grid{{0.5, 7.5, 0}, {1, 0, 0}, {0, -1, 0}, 8, 8};
  Stack() {
    scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
    const auto add = [&](double width, double z) {
      scene.add_face(std::vector<Point3>{{0, 0, z}, {width, 0, z}, {width, 8, z}, {0, 8, z}});
    };
    add(8, 0);
    add(8, 1);
    add(4, 1 + 0x1p-20);
  }
};

TEST_CASE("planted mistakes get the names they should", "[check][picture]") {
  const Stack stack;
  const Mesh mesh = stack.scene.mesh();
  const Image<TriangleId> nearest = cast(mesh, stack.scene.view, stack.grid).triangles;
  const auto check = [&](const Image<TriangleId>& shown, DepthFormat format) {
    return check_picture(mesh, stack.scene.view, stack.grid, shown, nearest,
                         DepthResolution{format, depth_range(mesh, stack.scene.view, stack.grid)});
  };
  CHECK(check(nearest, DepthFormat::float64).wrong == 0);
  CHECK(check(nearest, DepthFormat::float64).covered == 64);

  Image<TriangleId> shown = nearest;
  const TriangleId lowest(0), middle(2), uppermost(4);
  shown.at(1, 1) = TriangleId();  // a hole
  shown.at(6, 1) = uppermost;     // does not reach there
  shown.at(2, 2) = middle;        // 2^-20 too deep
  shown.at(3, 3) = lowest;        // 1 too deep
  const PictureCheck fine = check(shown, DepthFormat::float64), coarse = check(shown, DepthFormat::fixed16);
  CHECK(fine.mistakes.at(1, 1) == Mistake::edge);
  CHECK(fine.mistakes.at(6, 1) == Mistake::edge);
  CHECK(fine.mistakes.at(2, 2) == Mistake::order);
  CHECK(fine.mistakes.at(3, 3) == Mistake::order);
  CHECK((fine.wrong == 4 && fine.edge == 2 && fine.order == 2 && fine.tie == 0));
  CHECK(coarse.mistakes.at(2, 2) == Mistake::tie);
  CHECK(coarse.mistakes.at(3, 3) == Mistake::order);
  CHECK(coarse.wrong == 4);
}

TEST_CASE("a fixed depth buffer has no mistake but ties and edges", "[check][picture][property]") {
  for (const char* family : {"triangles", "polygons", "boxes"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      INFO(family << " " << seed << "\n" << scenes::to_text(scene));
      const Mesh mesh = scene.mesh();
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
      const Image<TriangleId> nearest = cast(mesh, scene.view, grid).triangles;
      const DepthRange range = depth_range(mesh, scene.view, grid);
      for (const DepthFormat format : {DepthFormat::fixed8, DepthFormat::fixed16, DepthFormat::fixed24}) {
        const DepthBuffer buffer = depth_buffer(mesh, scene.view, grid, range, {.format = format});
        const PictureCheck check =
            check_picture(mesh, scene.view, grid, buffer.triangles, nearest, DepthResolution{format, range, 0x1p-40});
        CHECK(check.order == 0);
      }
    }
}

}  // namespace
}  // namespace hsr
