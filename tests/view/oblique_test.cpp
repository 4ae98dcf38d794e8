#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/caster.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"
#include "tests/lines/checked_lines.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

using scenes::TestScene;

/// The unit cube: its front is y = 0, and what recedes from it goes to y = 1.
TestScene cube() {
  TestScene scene;
  scene.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (const std::vector<std::uint32_t>& face : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    scene.add_face(face);
  return scene;
}

std::array<double, 2> image_of(const View& view, const Point3& p) {
  const auto at = image(view, {Rational(p.x), Rational(p.y), Rational(p.z)});
  return {at[0].to_double(), at[1].to_double()};
}

TEST_CASE("an oblique view leaves the front as it is, and draws what recedes at the angle and the ratio", "[view][V12]") {
  struct Given {
    double degrees, ratio;
  };
  for (const Given g : {Given{45, 1}, {45, 0.5}, {30, 0.7}, {90, 1}, {135, 0.5}, {210, 0.25}, {-60, 2}, {0, 1}}) {
    const View view = oblique_view(named_view("front", {0.5, 0.5, 0.5}), g.degrees, g.ratio);
    INFO(g.degrees << ", " << g.ratio);
    const auto origin = image_of(view, {0, 0, 0}), right = image_of(view, {1, 0, 0}), up = image_of(view, {0, 0, 1}),
               back = image_of(view, {0, 1, 0});
    // To the last bit: the face's own plane is parallel to the paper, and the frame is the front's.
    const auto exact_origin = image(view, {Rational(0.0), Rational(0.0), Rational(0.0)});
    const auto exact_right = image(view, {Rational(1.0), Rational(0.0), Rational(0.0)});
    const auto exact_up = image(view, {Rational(0.0), Rational(0.0), Rational(1.0)});
    CHECK(exact_right[0] - exact_origin[0] == Rational(1.0));
    CHECK(exact_right[1] == exact_origin[1]);
    CHECK(exact_up[0] == exact_origin[0]);
    CHECK(exact_up[1] - exact_origin[1] == Rational(1.0));
    CHECK(right[0] > origin[0]);
    CHECK(up[1] > origin[1]);
    const double x = back[0] - origin[0], y = back[1] - origin[1];
    CHECK(std::fabs(std::hypot(x, y) - g.ratio) <= 4e-16 * g.ratio);
    CHECK(std::fabs(x - g.ratio * std::cos(g.degrees * std::numbers::pi / 180)) <= 5e-16);
    CHECK(std::fabs(y - g.ratio * std::sin(g.degrees * std::numbers::pi / 180)) <= 5e-16);
  }
}

TEST_CASE("quarter turns of an oblique view are exact, and planometric heights go straight up", "[view][V12]") {
  const View view = oblique_view(named_view("top"), 270, 1);
  CHECK((view.viewpoint.at == Point3{0, -1, 1}));
  CHECK(image_of(view, {0, 0, 1}) == std::array<double, 2>{0, 1});
  CHECK((oblique_view(named_view("front"), 90, 0.5).viewpoint.at == Point3{0, -1, 0.5}));
  CHECK((oblique_view(named_view("front"), 30, 1).viewpoint.at.z == 0.5));
}

TEST_CASE("what is no oblique view is refused", "[view]") {
  const View front = named_view("front");
  CHECK_THROWS_AS(oblique_view(front, 45, 0), InputError);
  CHECK_THROWS_AS(oblique_view(front, 45, -1), InputError);
  CHECK_THROWS_AS(oblique_view(front, HUGE_VAL, 1), InputError);
  CHECK_THROWS_AS(oblique_view(front, 45, std::nan("")), InputError);
  CHECK_THROWS_AS(oblique_view(perspective_view({0, -5, 0}, {0, 0, 0}, {0, 0, 1}), 45, 1), InputError);
}

TEST_CASE("three faces of a cube are visible in a cabinet projection", "[view][V12]") {
  TestScene scene = cube();
  scene.view = oblique_view(named_view("front", {0.5, 0.5, 0.5}), 45, 0.5);
  const CheckedLines lines(scene);
  CHECK(lines.differences() == "");
  // The receding edges are drawn up and to the right: the top and the right side are seen, the edges at 2 not.
  CHECK(lines(4, 6) == "outline: 0 visible 1");
  CHECK(lines(5, 7) == "sharp: 0 visible 1");
  CHECK(lines(1, 3) == "outline: 0 visible 1");
  CHECK(lines(0, 2) == "sharp: 0 hidden 1");
}

TEST_CASE("lines, fragments and orders agree with the nearest faces in oblique views", "[view][V12]") {
  for (const std::string name : {"boxes", "polygons", "triangles"}) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      TestScene scene = scenes::family(name).make(seed);
      scene.view = oblique_view(named_view(seed % 2 == 0 ? "front" : "top"), 45 + static_cast<double>(seed) * 30, 0.5);
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      CHECK(wrong_with(scene, all_edges()) == "");
      const Mesh mesh = scene.mesh();
      const SceneView seen(mesh, scene.view);
      const SampleGrid samples = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 32, 32);
      CHECK(check_fragments(seen, visible_fragments(seen), samples, cast(seen, samples).triangles).is_right());
      CHECK(check_order(seen, depth_sort(seen).order, samples).wrong == 0);
    }
  }
}

}  // namespace
}  // namespace hsr
