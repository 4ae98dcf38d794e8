#include <catch2/catch.hpp>

#include "hsr/surfaces/coincident_faces.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using namespace internal;

namespace {

scenes::TestScene from_above() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  return scene;
}

void add_square(scenes::TestScene& scene, double x, double y, double side, double z) {
  scene.add_face(std::vector<Point3>{{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}});
}

std::vector<FaceId> covered(const scenes::TestScene& scene, const std::vector<std::uint32_t>& kind,
                            Coplanar coplanar = Coplanar::first, Coincidence which = Coincidence::seen) {
  const Mesh mesh = scene.mesh();
  return under_coincident_faces(SceneView(mesh, scene.view, {.coplanar = coplanar}), kind, which);
}

TEST_CASE("the faces under coincident ones of another kind are found", "[ties][surfaces][S9]") {
  scenes::TestScene scene = from_above();
  add_square(scene, 0, 0, 8, 0);  // a board
  add_square(scene, 1, 1, 1, 0);  // three pieces of copper, the last over its border
  add_square(scene, 4, 4, 2, 0);
  add_square(scene, 7, 7, 2, 0);
  CHECK(covered(scene, {0, 1, 1, 1}) == std::vector{FaceId(1), FaceId(2), FaceId(3)});
  CHECK(covered(scene, {0, 1, 1, 1}, Coplanar::last) == std::vector{FaceId(0)});
  CHECK(covered(scene, {0, 1, 0, 0}) == std::vector{FaceId(1)});
  CHECK(covered(scene, {5, 5, 5, 5}).empty());
  // From below it is the same; edge-on there is nothing to see.
  scene.view = parallel_view({0, 0, -1}, {0, 1, 0});
  CHECK(covered(scene, {0, 1, 1, 1}).size() == 3);
  scene.view = parallel_view({1, 0, 0}, {0, 0, 1});
  CHECK(covered(scene, {0, 1, 1, 1}).empty());
}

TEST_CASE("touching, and an ulp apart, is not coinciding", "[ties][surfaces][S9]") {
  scenes::TestScene scene = from_above();
  add_square(scene, 0, 0, 8, 0);
  add_square(scene, 8, 0, 8, 0);
  add_square(scene, 2, 2, 1, 5e-324);
  CHECK(covered(scene, {0, 1, 2}).empty());
}

TEST_CASE("what is hidden in front of coincident faces counts only through transparent ones", "[ties][surfaces][S9]") {
  // A box without a lid on the ground: its bottom coincides with the ground, and a roof covers all of that.
  scenes::TestScene scene = from_above();
  add_square(scene, 0, 0, 8, 0);
  add_square(scene, 2, 2, 2, 0);
  add_square(scene, 2, 2, 2, 3);
  CHECK(covered(scene, {0, 1, 2}).empty());
  CHECK(covered(scene, {0, 1, 2}, Coplanar::first, Coincidence::all) == std::vector{FaceId(1)});
  // Two half roofs with a slit between them, and two without.
  for (const double slit : {0.0, 0x1p-40}) {
    scenes::TestScene halves = from_above();
    add_square(halves, 0, 0, 8, 0);
    add_square(halves, 2, 2, 2, 0);
    add_square(halves, 1, 1, 2, 3);
    add_square(halves, 1, 3, 2, 3);
    add_square(halves, 3 + slit, 1, 2, 4);
    add_square(halves, 3 + slit, 3, 2, 4);
    CHECK(covered(halves, {0, 1, 2, 2, 2, 2}).size() == (slit > 0 ? 1 : 0));
  }
}

TEST_CASE("coincident faces before the near plane do not count", "[ties][surfaces][S9]") {
  scenes::TestScene scene;
  scene.view = scenes::from_eye({0, 0, 4}, {0, 0, 0}, 0.5);  // the near plane is z = 2
  for (const double z : {3.0, 1.0}) {
    scene.polygons = {};
    scene.points.clear();
    add_square(scene, 0, 0, 1, z);
    add_square(scene, 0, 0, 1, z);
    CHECK(covered(scene, {0, 1}).size() == (z < 2 ? 1 : 0));
  }
}

}  // namespace
}  // namespace hsr
