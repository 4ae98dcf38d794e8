#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/lines/labelled_scene.h"

// Small shapes of which the right lines are plain.

namespace hsr {

namespace {

// Two boxes side by side, the second as high, or higher: one flat side is one flat side.
Labelled two_boxes(double height) {
  Labelled x;
  x.add_box({0, 0, 0}, {4, 3, 3}, 0);
  x.add_box({4, 0, 0}, {9, 3, height}, 1);
  return x;
}

TEST_CASE("one flat side is one flat side, however high its neighbours are", "[lines][shape][C12][C18]") {
  for (const double height : {3.0, 4.0}) {
    Labelled x = two_boxes(height);
    x.scene.view = scenes::from_direction({0, -1, 0});
    INFO(x.ink());
    CHECK(lines_of(x, "visible joint") == 1);
    CHECK(lines_of(x, "visible sharp") == 0);
    CHECK(lines_of(x, "visible boundary") == 0);
    // Of one object there is no joint; of two materials there is more.
    Labelled one = x, painted = x;
    one.labels.object.assign(12, 0);
    CHECK(lines_of(one, "joint") == 0);
    for (std::size_t f = 6; f < 12; ++f) painted.labels.material[f] = 1;
    CHECK(lines_of(painted, "visible material") == 1);
    CHECK(lines_of(painted, "joint") == 0);
  }
}

// Two boxes with the same sides that overlap, and a third around a part of an edge of both: there it is inside of a body, elsewhere
// it is not, however long the edges are.
TEST_CASE("an edge that leads into a body is cut where it enters", "[lines][shape][C21]") {
  Labelled x;
  x.add_box({0, 0, 0}, {4, 4, 10});
  x.add_box({0, 0, 3}, {4, 4, 13});
  x.add_box({-2, -2, 5}, {2, 2, 7});
  for (const Point3& direction : {Point3{0, -1, 0}, Point3{1, -2, 1}, Point3{-3, 2, 1}}) {
    x.scene.view = scenes::from_direction(direction);
    CHECK(difference(x.ink(), recut(x, with_cut_sides).ink()) == "");
    CHECK(difference(x.ink(), recut(x, in_halves).ink()) == "");
  }
}

TEST_CASE("a side that is cut at a T is smooth", "[lines][shape][C12]") {
  Labelled x;
  const std::vector<std::vector<Point3>> panels = {{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}},
                                                   {{4, 0, 0}, {8, 0, 0}, {8, 0, 1}, {4, 0, 1}},
                                                   {{4, 0, 1}, {8, 0, 1}, {8, 0, 4}, {4, 0, 4}}};
  for (const auto& panel : panels) x.add_face(panel);
  for (const Point3& direction : {Point3{0, -1, 0}, Point3{1, -2, 1}}) {
    x.scene.view = scenes::from_direction(direction);
    CHECK(lines_of(x, "visible boundary") == 4);
    CHECK(lines_of(x, "visible") == 4);
  }
}

// Bricks of 4 x 1 in courses, each course shifted by half a brick.
TEST_CASE("the joints of a bond are all joints", "[lines][shape][C18]") {
  Labelled x;
  std::uint32_t brick = 0;
  for (int course = 0; course < 3; ++course)
    for (int k = 0; k < 3; ++k, ++brick) {
      const double left = 4 * k + 2 * (course % 2);
      x.add_face(
          {{left, 0, double(course)}, {left + 4, 0, double(course)}, {left + 4, 0, course + 1.0}, {left, 0, course + 1.0}},
          brick);
    }
  x.scene.view = scenes::from_direction({0, -1, 0});
  INFO(x.ink());
  CHECK(lines_of(x, "sharp") == 0);
  CHECK(lines_of(x, "visible joint") == 2 + 6);  // two beds, and two head joints in each course
}

/// A slab from z = 0 to 1, and a column under it whose head touches it, or stands in it, or is one body with it.
TEST_CASE("a column under a slab is dashed, be it a body of its own or not", "[lines][shape][C17][C19]") {
  Labelled touching, gap, fused;
  touching.add_box({0, 0, 0}, {10, 8, 1}, 0);
  touching.add_box({3, 3, -5}, {6, 5, 0}, 1);
  gap.add_box({0, 0, 0}, {10, 8, 1}, 0);
  gap.add_box({3, 3, -5}, {6, 5, -1}, 1);
  // One body: the underside of the slab has a hole, as a keyhole, where the column begins.
  fused.add_box({0, 0, 0}, {10, 8, 1}, 0);
  fused = recut(fused, [](const Mesh&, FaceId face, const Ring& ring, Labelled& to) {
    if (face.value != 0) return std::vector<Ring>{ring};
    const auto n = static_cast<std::uint32_t>(to.scene.points.size());
    for (const double z : {0.0, -5.0})
      for (const Point3& p : {Point3{3, 3, z}, Point3{6, 3, z}, Point3{6, 5, z}, Point3{3, 5, z}}) to.scene.points.push_back(p);
    return std::vector<Ring>{{ring[0], ring[1], ring[2], ring[3], ring[0], n, n + 1, n + 2, n + 3, n},
                             {n, n + 1, n + 5, n + 4},
                             {n + 1, n + 2, n + 6, n + 5},
                             {n + 2, n + 3, n + 7, n + 6},
                             {n + 3, n, n + 4, n + 7},
                             {n + 4, n + 5, n + 6, n + 7}};
  });
  for (Labelled* x : {&touching, &gap, &fused}) x->scene.view = scenes::from_direction({0, 0, 1});
  CHECK(lines_of(touching, "hidden") == 4);
  CHECK(by_visibility(touching.ink()) == by_visibility(gap.ink()));
  CHECK(by_visibility(touching.ink()) == by_visibility(fused.ink()));
}

/// A sheet at z = 0, of one face, and a column under it whose head touches it.
TEST_CASE("a column under a single sheet is dashed all around, and nothing of it is seen on the sheet", "[lines][shape][C17]") {
  Labelled x;
  x.add_face({{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}}, 0);
  x.add_box({3, 3, -1}, {6, 5, 0}, 1);
  for (const Point3& direction : {Point3{0, 0, 1}, Point3{1, -1, 2}}) {
    x.scene.view = scenes::from_direction(direction);
    INFO(x.ink());
    CHECK(lines_of(x, "visible") == lines_of(x, "visible boundary") + lines_of(x, "visible joint"));
    CHECK(lines_of(x, "visible boundary") == 4);
    const bool is_from_above = direction.x == 0;  // the foot is behind the rim
    CHECK(lines_of(x, "hidden") == (is_from_above ? 4 : 12));
    // Where something stands on the sheet, before the rim, it is hidden as under a slab.
    Labelled covered = x;
    covered.add_box({4, 2, 0.25}, {5, 4, 1});
    CHECK(lines_of(covered, "hidden") >= (is_from_above ? 4 : 12));
  }
  // From below it is seen where it is joined, and the sheet is behind it.
  x.scene.view = scenes::from_direction({1, -1, -2});
  CHECK(lines_of(x, "visible boundary") == 4);
  CHECK(lines_of(x, "visible") > 4 + 6);
}

TEST_CASE("the foot of a wall seen edge-on is an edge like any other", "[lines][shape][C2][C7]") {
  Labelled x;
  x.add_face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  x.add_face({{2, 4, 0}, {6, 4, 0}, {6, 4, 3}, {2, 4, 3}});
  x.scene.view = scenes::from_direction({0, 0, 1});
  CHECK(lines_of(x, "visible sharp") + lines_of(x, "visible outline") + lines_of(x, "visible boundary") == 5);
  // Under the floor it is behind: hidden, and no line on the floor.
  for (std::size_t k = 4; k < 8; ++k) x.scene.points[k].z = -x.scene.points[k].z;
  CHECK(lines_of(x, "visible") == 4);
  CHECK(lines_of(x, "hidden sharp") + lines_of(x, "hidden boundary") == 1);
}

TEST_CASE("where two boxes touch, their walls seen edge-on make no line", "[lines][shape][C17]") {
  Labelled x = two_boxes(3);
  x.scene.view = scenes::from_direction({0, 0, 1});  // both walls of the joint are edge-on and coincide
  CHECK(lines_of(x, "visible sharp") == 0);
  CHECK(lines_of(x, "visible joint") == 1);
  CHECK(lines_of(x, "hidden") == 0);
}

TEST_CASE("a sheet that is stored twice is pierced as one is", "[lines][shape][C6][C17]") {
  Labelled whole;
  for (int k = 0; k < 2; ++k) whole.add_face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  whole.add_face({{0, 2, -1}, {8, 2, -1}, {8, 6, 1}, {0, 6, 1}});
  Labelled cut;
  for (int k = 0; k < 2; ++k) {
    cut.add_face({{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}});
    cut.add_face({{0, 4, 0}, {8, 4, 0}, {8, 8, 0}, {0, 8, 0}});
  }
  cut.add_face({{0, 2, -1}, {8, 2, -1}, {8, 4, 0}, {0, 4, 0}});
  cut.add_face({{0, 4, 0}, {8, 4, 0}, {8, 6, 1}, {0, 6, 1}});
  for (const Point3& direction : {Point3{0, 0, 1}, Point3{1, -1, 1}, Point3{2, -3, 1}}) {
    whole.scene.view = cut.scene.view = scenes::from_direction(direction);
    CHECK(lines_of(whole, "intersection") > 0);
    CHECK(difference(whole.ink(), cut.ink()) == "");
  }
}

TEST_CASE("facets that meet at the crease angle are all alike", "[lines][shape][C20]") {
  Labelled x;
  const int n = 12;  // 30 degrees, but for the rounding of sines
  for (int k = 0; k < n; ++k) {
    const auto at = [](int i) { return 2 * 3.14159265358979323846 * i / 12; };
    x.add_face({{10 * std::cos(at(k)), 10 * std::sin(at(k)), 0},
                {10 * std::cos(at(k + 1)), 10 * std::sin(at(k + 1)), 0},
                {10 * std::cos(at(k + 1)), 10 * std::sin(at(k + 1)), 20},
                {10 * std::cos(at(k)), 10 * std::sin(at(k)), 20}});
  }
  for (Point3& p : x.scene.points) {  // as a file of six digits has it
    p.x = std::round(p.x * 1e5) / 1e5;
    p.y = std::round(p.y * 1e5) / 1e5;
  }
  x.scene.view = scenes::from_direction({2, -3, 1.5});
  CHECK(lines_of(x, "sharp") == 0);
}

}  // namespace
}  // namespace hsr
