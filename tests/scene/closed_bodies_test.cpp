#include "hsr/scene/closed_bodies.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/projected_mesh.h"
#include "tests/lines/checked_lines.h"
#include "tests/scenes/test_scene.h"

// ClosedBodies: what is one and what is not, and that leaving out their far sides changes nothing.

namespace hsr {

using namespace internal;

namespace {

using scenes::TestScene;

void add_box(TestScene& scene, const Point3& low, const Point3& high, bool inward = false) {
  const auto n = static_cast<std::uint32_t>(scene.points.size());
  for (std::uint32_t k = 0; k < 8; ++k)
    scene.points.push_back({(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y, (k & 4U) != 0 ? high.z : low.z});
  for (std::vector<std::uint32_t> face : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    if (inward) std::swap(face[1], face[3]);
    for (auto& c : face) c += n;
    scene.add_face(face);
  }
}

TestScene box(const Point3& low = {0, 0, 0}, const Point3& high = {2, 3, 4}, bool inward = false) {
  TestScene scene;
  add_box(scene, low, high, inward);
  scene.view = scenes::from_direction({1, -2, 3});
  return scene;
}

struct Found {
  std::size_t bodies, far_triangles;
  bool is_convex;
};
bool operator==(const Found& a, const Found& b) {
  return a.bodies == b.bodies && a.far_triangles == b.far_triangles && a.is_convex == b.is_convex;
}
std::ostream& operator<<(std::ostream& out, const Found& f) {
  return out << f.bodies << " bodies, " << f.far_triangles << " far triangles" << (f.is_convex ? ", convex" : "");
}

Found found(const TestScene& scene) {
  const Mesh mesh = scene.mesh();
  const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
  const StarShapedBodies star_shaped{ScaledMesh(mesh)};
  const ClosedBodies bodies(projected, star_shaped);
  Found f{bodies.count(), 0, bodies.is_one_convex_body()};
  for (const std::uint8_t far : bodies.far_sides()) f.far_triangles += far;
  return f;
}

/// Two apexes over a ring: a double pyramid that goes `turns` times around.
TestScene double_pyramid(int n, int turns, const std::function<double(int)>& radius) {
  TestScene scene;
  scene.points = {{0, 0, 1}, {0, 0, -1}};
  const auto first = static_cast<std::uint32_t>(scene.points.size());
  for (int k = 0; k < n * turns; ++k) {
    const double a = 6.283185307179586 * k / n, r = radius(k);
    scene.points.push_back({r * std::cos(a), r * std::sin(a), 0.01 * (k % 3)});
  }
  const auto m = static_cast<std::uint32_t>(n * turns);
  for (std::uint32_t k = 0; k < m; ++k) {
    scene.add_face({0, first + k, first + (k + 1) % m});
    scene.add_face({1, first + (k + 1) % m, first + k});
  }
  scene.view = scenes::from_direction({0.3, -1, 0.4});
  return scene;
}

TEST_CASE("a box is one convex body, whichever way its faces are turned", "[lines][bodies]") {
  CHECK(found(box()) == Found{1, 6, true});
  CHECK(found(box({0, 0, 0}, {2, 3, 4}, true)) == Found{1, 6, true});
  TestScene scene = box();
  scene.view = scenes::from_direction({0, -1, 0});
  CHECK(found(scene) == Found{1, 2, true});
  for (const double size : {0x1p-900, 0x1p900}) CHECK(found(box({0, 0, 0}, {size, size, size})) == Found{1, 6, true});
}

TEST_CASE("what is not closed, or disagrees in orientation, is no body", "[lines][bodies]") {
  TestScene open = box();
  open.polygons.corners.resize(20);
  open.polygons.first.pop_back();
  CHECK(found(open) == Found{0, 0, false});
  TestScene flipped = box();
  std::swap(flipped.polygons.corners[1], flipped.polygons.corners[3]);
  CHECK(found(flipped) == Found{0, 0, false});
}

TEST_CASE("a body that the near plane cuts, or that is around the eye, is none", "[lines][bodies]") {
  TestScene scene = box();
  scene.view = scenes::from_eye({1, -10, 2}, {1, 0, 2});
  CHECK(found(scene) == Found{1, 10, true});
  scene.view = scenes::from_eye({1, -10, 2}, {1, 0, 2}, 1);  // touches the front
  CHECK(found(scene) == Found{1, 10, true});
  scene.view = scenes::from_eye({1, -10, 2}, {1, 0, 2}, 1.125);
  CHECK(found(scene) == Found{0, 0, false});
  scene.view = scenes::from_eye({1, 1, 2}, {1, 3, 2});
  CHECK(found(scene) == Found{0, 0, false});
  // One beyond and one before: convex, but not alone.
  add_box(scene, {0, 10, 0}, {2, 13, 4});
  CHECK(found(scene) == Found{1, 10, false});
}

TEST_CASE("bodies may be star-shaped; one convex body is not dented and stands alone", "[lines][bodies]") {
  const auto round = [](int) { return 1.0; };
  const auto star = [](int k) { return k % 2 == 0 ? 1.0 : 0.4; };
  CHECK(found(double_pyramid(8, 1, star)).bodies == 1);
  CHECK_FALSE(found(double_pyramid(8, 1, star)).is_convex);
  CHECK(found(double_pyramid(12, 1, round)).bodies == 1);
  TestScene two = box();
  add_box(two, {5, 5, 5}, {6, 6, 6});
  CHECK(found(two) == Found{2, 12, false});
  TestScene with_wire = box();
  with_wire.points.push_back({9, 9, 9});
  with_wire.polygons.segments.push_back({0, 8});
  CHECK(found(with_wire) == Found{1, 6, false});
  // Boxes that share an edge are two bodies all the same.
  TestScene sharing = box({0, 0, 0}, {1, 1, 1});
  add_box(sharing, {1, 1, 0}, {2, 2, 1});
  CHECK(found(sharing) == Found{2, 12, false});
  // Faces without area are none.
  TestScene with_nothing = box();
  with_nothing.add_face({0, 1, 0});
  with_nothing.add_face({0, 1, 1, 0});
  CHECK(found(with_nothing) == Found{1, 6, true});
}

TEST_CASE("a closed surface whose middle does not see all of it is no body", "[lines][bodies]") {
  // A channel, U in section; each of its faces first, so that the ray goes through each.
  const std::vector<std::array<double, 2>> section = {{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 1}, {2, 1}, {2, 6}, {0, 6}};
  const auto n = static_cast<std::uint32_t>(section.size());
  for (std::uint32_t first = 0; first < n; ++first) {
    TestScene channel;
    for (const double y : {0.0, 9.0})
      for (const auto& p : section) channel.points.push_back({p[0], y, p[1]});
    std::vector<std::uint32_t> front, back;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = (first + k) % n, b = (a + 1) % n;
      channel.add_face({a, n + a, n + b, b});
      front.push_back(k);
      back.push_back(2 * n - 1 - k);
    }
    channel.add_face(front);
    channel.add_face(back);
    channel.view = scenes::from_direction({1, -2, 3});
    CHECK(found(channel) == Found{0, 0, false});
  }
  // A box with a corner pulled through the opposite side.
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    TestScene pulled = box();
    Point3& p = pulled.points[corner];
    p = {p.x == 0 ? 4.0 : -2.0, p.y == 0 ? 5.0 : -2.0, p.z == 0 ? 7.0 : -3.0};
    CHECK(found(pulled) == Found{0, 0, false});
    CHECK(wrong_with(pulled) == "");
  }
}

TEST_CASE("a surface that winds around its middle twice is no body", "[lines][bodies]") {
  // Every face is seen from the middle from the same side, and yet it passes through itself.
  const TestScene twice = double_pyramid(7, 2, [](int k) { return k < 7 ? 1.0 : 0.7; });
  CHECK(found(twice) == Found{0, 0, false});
  CHECK(wrong_with(twice) == "");
}

/// Whether every setting of the two stages gives what the oracle says.
std::string wrong_with_stages(const TestScene& scene) {
  std::string wrong = wrong_with(scene);
  const Mesh mesh = scene.mesh();
  for (const When back_faces : {When::never, When::always})
    for (const When convex_body : {When::never, When::always}) {
      const LineOptions options = all_edges();
      SceneOptions chosen;
      chosen.when(Stage::back_faces) = back_faces;
      chosen.when(Stage::convex_body) = convex_body;
      const SceneView view(mesh, scene.view, chosen);
      for (const std::string& line : oracle::compare_with_oracle(view, visible_lines(view, options), options))
        wrong += line + "\n";
    }
  return wrong;
}

TEST_CASE("convex bodies seen from everywhere are drawn as without the stage", "[lines][bodies][oracle]") {
  std::mt19937 random(11);
  const auto at = [&] { return static_cast<double>(static_cast<int>(random() % 9)) - 4; };
  std::size_t untested = 0;
  for (int round = 0; round < 60; ++round) {
    TestScene scene = box({0, 0, 0}, {1.0 + round % 3, 1, 2});
    Point3 d{at(), at(), at()};
    if (d.x == 0 && d.y == 0 && d.z == 0) d.z = 1;
    scene.view = round % 3 == 0 ? scenes::from_eye({8 + at() / 2, at(), at()}, {0, 0, 0}) : scenes::from_direction(d);
    CHECK(wrong_with_stages(scene) == "");
    if (visible_lines(scene.mesh(), scene.view).plan.method == "none") ++untested;
  }
  CHECK(untested == 60);
}

TEST_CASE("bodies before, behind, beside and upon one another are drawn as without the stage", "[lines][bodies][oracle]") {
  std::mt19937 random(12);
  const auto at = [&](int n) { return static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(n))); };
  std::size_t bodies = 0;
  for (int round = 0; round < 80; ++round) {
    TestScene scene;
    for (int k = 0; k < 4; ++k) {
      const Point3 low{at(4), at(4), at(4)};
      add_box(scene, low, {low.x + 1 + at(2), low.y + 1 + at(2), low.z + 1 + at(2)}, k % 2 == 0);
    }
    // Something to be hidden, and a wire.
    scene.add_face(std::vector<Point3>{{at(4), at(4), at(4)}, {at(6), at(4), at(4)}, {at(4), 2 + at(4), at(5)}});
    scene.points.push_back({at(6), at(6), at(6)});
    scene.polygons.segments.push_back({0, static_cast<std::uint32_t>(scene.points.size() - 1)});
    const double x = at(5) - 2, y = at(5) - 2, z = at(5) - 2;
    scene.view = round % 2 == 0 || (x == 0 && y == 0 && z == 0) ? scenes::from_eye({12 + x, 3 + 4 * y, 3 + 2 * z}, {2, 2, 2})
                                                                : scenes::from_direction({x, y, z});
    bodies += found(scene).bodies;
    CHECK(wrong_with_stages(scene) == "");
  }
  CHECK(bodies > 200);
}

}  // namespace
}  // namespace hsr
