#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/lines/checked_lines.h"

// What a draughtsman expects of simple bodies.

namespace hsr {
namespace {

using scenes::TestScene;

constexpr double pi = 3.14159265358979323846;

TestScene box(double x, double y, double z, const View& view) {
  TestScene scene;
  for (unsigned i = 0; i < 8; ++i)
    scene.points.push_back({(i & 1U) != 0 ? x : 0, (i & 2U) != 0 ? y : 0, (i & 4U) != 0 ? z : 0});
  for (const auto& f : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    scene.add_face(f);
  scene.view = view;
  return scene;
}

int count(const CheckedLines& lines, const std::string& intervals) {
  int n = 0;
  for (const auto& e : lines.edges()) n += oracle::intervals_text(e) == intervals ? 1 : 0;
  return n;
}

TEST_CASE("a box seen face-on shows four lines", "[lines][drawing][H4][H9]") {
  for (const Point3& d : {Point3{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
    const TestScene scene = box(2, 3, 4, scenes::from_direction(d));
    const CheckedLines lines(scene);
    CHECK(lines.differences() == "");
    CHECK(count(lines, "0 visible 1") == 4);
    CHECK(count(lines, "0 hidden 1") == 4);
    CHECK(count(lines, "nothing") == 4);
    for (const auto& e : lines.edges())
      if (!e.cuts.empty()) CHECK(e.edge_class == EdgeClass::outline);
  }
}

TEST_CASE("a box seen aslant shows nine edges and hides three", "[lines][drawing]") {
  for (const auto& view :
       {scenes::from_direction({1, -1, 1}), scenes::from_direction({1, 2, 3}), scenes::from_eye({9, -7, 8}, {1, 1, 1})}) {
    const CheckedLines lines(box(2, 3, 4, view));
    CHECK(lines.differences() == "");
    CHECK(count(lines, "0 visible 1") == 9);
    CHECK(count(lines, "0 hidden 1") == 3);
  }
}

TEST_CASE("the far corner of a cube is exactly behind the near one along its diagonal", "[lines][drawing][V1]") {
  const CheckedLines lines(box(1, 1, 1, scenes::from_direction({1, 1, 1})));
  CHECK(lines.differences() == "");
  CHECK(lines(0, 1) == "sharp: 0 hidden 1");  // its three edges lie behind the front three edges' images
  CHECK(lines(0, 2) == "sharp: 0 hidden 1");
  CHECK(lines(0, 4) == "sharp: 0 hidden 1");
  CHECK(count(lines, "0 visible 1") == 9);
}

TEST_CASE("a partition welded to a facade from behind is not drawn on it", "[lines][drawing][C9]") {
  TestScene scene;
  scene.points = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 0, 3}, {2, 0, 3}, {4, 0, 3}, {2, 4, 0}, {2, 4, 3}};
  scene.add_face({0, 1, 4, 3});
  scene.add_face({1, 2, 5, 4});
  scene.add_face({1, 6, 7, 4});
  for (const auto& view :
       {scenes::from_direction({0, -1, 0}), scenes::from_direction({1, -3, 1}), scenes::from_direction({-2, -1, 1}),
        scenes::from_eye({2, -5, 1}, {2, 0, 1}), scenes::from_eye({5, -5, 2}, {2, 0, 1})}) {
    scene.view = view;
    const CheckedLines lines(scene);
    CHECK(lines.differences() == "");
    CHECK(lines(1, 4) == "smooth: 0 visible 1");
    CHECK(CheckedLines(scene, {})(1, 4) == "sharp: 0 hidden 1");  // of what touches from behind
  }
  scene.view = scenes::from_direction({0, -1, 0});
  CHECK(CheckedLines(scene)(6, 7) == "boundary: 0 hidden 1");
  scene.view = scenes::from_direction({1, 3, 1});  // from behind the partition divides the facade
  CHECK(CheckedLines(scene)(1, 4) == "sharp: 0 visible 1");
}

// A prism over a regular 24-gon: neighbouring sides deviate by 15 degrees.
TestScene prism(const View& view) {
  TestScene scene;
  constexpr std::uint32_t n = 24;
  for (const double z : {0.0, 2.0})
    for (std::uint32_t i = 0; i < n; ++i) scene.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), z});
  std::vector<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < n; ++i) {
    low.insert(low.begin(), i);
    high.push_back(n + i);
    scene.add_face({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  scene.add_face(low);
  scene.add_face(high);
  scene.view = view;
  return scene;
}

TEST_CASE("a prism with dihedral angles of 15 degrees shows its rims and two outlines", "[lines][drawing][C7]") {
  const auto verticals = [](const CheckedLines& lines, EdgeClass c) {
    int n = 0;
    for (const auto& e : lines.edges()) n += e.b.value == e.a.value + 24 && e.edge_class == c ? 1 : 0;
    return n;
  };
  SECTION("seen from the side") {
    const TestScene scene = prism(scenes::from_direction({5, 1, 0}));
    const CheckedLines lines(scene);
    CHECK(lines.differences() == "");
    CHECK(verticals(lines, EdgeClass::outline) == 2);
    CHECK(verticals(lines, EdgeClass::smooth) == 22);
    LineOptions options = all_edges();
    options.crease = 14;
    CHECK(verticals(CheckedLines(scene, options), EdgeClass::sharp) == 22);
  }
  SECTION("seen from the top, flat") {
    const CheckedLines lines(prism(scenes::from_direction({0, 0, 1})));
    CHECK(lines.differences() == "");
    CHECK(verticals(lines, EdgeClass::smooth) == 24);
    CHECK(count(lines, "nothing") == 24);
    CHECK(count(lines, "0 visible 1") == 24);  // the upper rim, and exactly behind it
    CHECK(count(lines, "0 hidden 1") == 24);   // the lower one
  }
  SECTION("seen from above, aslant") {
    const CheckedLines lines(prism(scenes::from_direction({5, 1, 3})));
    CHECK(lines.differences() == "");
    for (const auto& e : lines.edges())
      if (e.a.value >= 24) CHECK(oracle::intervals_text(e) == "0 visible 1");
    CHECK(verticals(lines, EdgeClass::outline) == 2);
  }
}

TEST_CASE("a non-planar quad hides part of its own edge", "[lines][drawing][H6]") {
  TestScene scene;
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 2}, {3, -1, 3}};
  scene.add_face({0, 1, 2, 3});
  scene.view = scenes::from_direction({0, 0, 1});
  const CheckedLines lines(scene);
  CHECK(lines.differences() == "");
  CHECK(lines(0, 1) == "boundary: 0 hidden 4/5 visible 1");
}

TEST_CASE("a diagonal is drawn where it is an outline and nowhere else", "[lines][drawing][C15]") {
  TestScene scene;
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 2}, {0, 4, 0}};
  scene.add_face({0, 1, 2, 3});
  const Mesh mesh = scene.mesh();
  REQUIRE(mesh.triangles.size() == 2);
  int outlines = 0, absent = 0;
  for (const Point3& d : {Point3{0, 0, 1}, {1, 0, 0}, {1, -1, 1}, {-1, 1, 1}, {1, 0, -1}, {-4, 1, 1}, {1, -4, 1}, {-3, 2, 0}}) {
    scene.view = scenes::from_direction(d);
    const CheckedLines lines(scene);
    CHECK(lines.differences() == "");
    for (const auto& [a, b] : {std::pair{0U, 2U}, {1U, 3U}}) {
      const std::string text = lines(a, b);
      outlines += text.find("outline: ") == 0 ? 1 : 0;
      absent += text == "absent" ? 1 : 0;
    }
  }
  CHECK(outlines > 0);
  CHECK(absent > 8);  // one of the two is never there
  CHECK(outlines + absent == 16);
}

}  // namespace
}  // namespace hsr
