#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "hsr/check/sample_checks.h"
#include "hsr/surfaces/fragment_invariants.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/lines/checked_lines.h"
#include "tests/scenes/random_scenes.h"
#include "tests/surfaces/checked_surfaces.h"

// Scenes at the ends of the doubles, and faces that nearly coincide.

namespace hsr {

using namespace internal;

namespace {

using scenes::TestScene;

TestScene scaled(TestScene scene, double by) {
  const auto scale = [&](const Point3& p) { return Point3{p.x * by, p.y * by, p.z * by}; };
  for (Point3& p : scene.points) p = scale(p);
  const View& view = scene.view;
  scene.view = view.viewpoint.is_direction ? scenes::from_direction(view.viewpoint.at)
                                           : scenes::from_eye(scale(view.viewpoint.at), scale(view.target), view.near);
  return scene;
}

TEST_CASE("scenes of every size have the fragments and lines of the oracle", "[surfaces][stiff][E1]") {
  for (const double by : {0x1p900, 0x1p-900, 1e150, 1e-150, 1e300, 1e-300})
    for (const char* family : {"triangles", "polygons", "slopes", "around_the_eye"})
      for (std::uint64_t seed = 700'000; seed < 700'004; ++seed) {
        const TestScene scene = scaled(scenes::family(family).make(seed), by);
        INFO(by << " " << family << " " << seed);
        CHECK(wrong_fragments(scene) == "");
        CHECK(wrong_with(scene) == "");
      }
}

// A square whose image is 1e12 times as long as it is wide, somewhere over a floor.
TEST_CASE("slivers of 1e12 to 1 are where they are", "[surfaces][stiff]") {
  std::mt19937_64 random(11);
  const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  for (int k = 0; k < 12; ++k) {
    TestScene scene;
    scene.view = k % 3 == 0   ? scenes::from_direction({0, 0, 1})
                 : k % 3 == 1 ? scenes::from_direction({1, 2, 3})
                              : scenes::from_eye({3, -2, 9}, {0, 0, 0});
    scene.add_face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
    for (int sliver = 0; sliver < 3; ++sliver) {
      const double a = 7 * unit(), c = std::cos(a), s = std::sin(a), z = unit() - 0.25, w = 1e-12;
      scene.add_face({{-c, -s, z}, {c, s, z + 0.5}, {c - w * s, s + w * c, z + 0.5}});
    }
    CHECK(wrong_fragments(scene) == "");
    CHECK(wrong_with(scene) == "");
  }
}

void agree_on_a_hundred_triangles(std::initializer_list<int> exponents) {
  for (const int exponent : exponents) {
    const double slope = std::pow(10, exponent);
    std::mt19937_64 random(static_cast<std::uint64_t>(-exponent));
    const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
    TestScene scene;
    scene.view = scenes::from_direction({0, 0, 1});
    for (int k = 0; k < 100; ++k) {
      const double a = 3.2 * unit(), sx = slope * unit(), sy = slope * unit(), lift = slope * unit() / 4;
      const auto corner = [&](double turn) {
        const double x = std::cos(a + turn), y = std::sin(a + turn);
        return Point3{x, y, sx * x + sy * y + lift};
      };
      scene.add_face({corner(0), corner(2.1), corner(4.2)});
    }
    const Mesh mesh = scene.mesh();
    const VisibleFragments found = visible_fragments(mesh, scene.view);
    CHECK(found.fragments.size() > 100);
    CHECK(exact_text(mesh, scene.view, found) == exact_text(mesh, scene.view, roberts_surfaces(mesh, scene.view)));
    CHECK_NOTHROW(check_invariants(ProjectedMesh(mesh, scene.view, Arithmetic::staged), found));
    const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 256, 256);
    CHECK(check_fragments(mesh, scene.view, found, grid).is_right());
    LineOptions options = all_edges();
    options.method = LineMethod::roberts;
    const auto by_roberts = oracle::seen_edges(mesh, scene.view, visible_lines(mesh, scene.view, options));
    options.method = LineMethod::appel;
    SceneOptions always;
    always.stages.fill(When::always);
    const SceneView view(mesh, scene.view, always);
    CHECK(oracle::differences(by_roberts, oracle::seen_edges(mesh, scene.view, visible_lines(view, options))).empty());
  }
}

TEST_CASE("a hundred large triangles that cross at slopes of 1e-3 and 1e-15", "[surfaces][stiff]") {
  agree_on_a_hundred_triangles({-3, -15});
}
TEST_CASE("a hundred large triangles that cross at slopes between", "[surfaces][stiff][long]") {
  agree_on_a_hundred_triangles({-5, -6, -7, -8, -9, -10, -11, -12, -13, -14});
}

}  // namespace
}  // namespace hsr
