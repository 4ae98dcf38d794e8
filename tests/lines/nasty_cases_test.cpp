#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "tests/lines/checked_lines.h"

// The nasty cases, each with its exact answer. "Top" is a viewer at z = +infinity; an edge is named by its points' numbers.

namespace hsr {
namespace {

using oracle::Q;
using scenes::TestScene;

const Point3 top = {0, 0, 1};
const double huge = std::numeric_limits<double>::infinity();

struct Polygon {
  std::vector<Point3> corners;
};

TestScene seen_from(const View& view, const std::vector<Polygon>& faces, const std::vector<std::array<Point3, 2>>& wires = {}) {
  TestScene scene;
  for (const Polygon& f : faces) scene.add_face(f.corners);
  for (const auto& [a, b] : wires) {
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    scene.points.push_back(a);
    scene.points.push_back(b);
    scene.polygons.segments.push_back({n, n + 1});
  }
  scene.view = view;
  return scene;
}

TestScene from_top(const std::vector<Polygon>& faces, const std::vector<std::array<Point3, 2>>& wires = {}) {
  return seen_from(scenes::from_direction(top), faces, wires);
}

// Both roberts and the oracle agree on the whole scene, not only on the edges that a test names.
CheckedLines checked(const TestScene& scene) {
  CheckedLines lines(scene);
  INFO(scenes::to_text(scene));
  CHECK(lines.differences() == "");
  return lines;
}

TEST_CASE("three triangles that cover one another in a cycle", "[lines][nasty]") {  // 1
  const auto e = checked(from_top({{{{-8, -3, 0}, {8, -3, 16}, {8, -4, 16}}},
                                   {{{6, -7, 0}, {-2, 9, 16}, {-1, 9, 16}}},
                                   {{{2, 9, 0}, {-6, -7, 16}, {-7, -7, 16}}}}));
  // C passes over A's long edges near their low end; A does the same to B, and B to C.
  CHECK(e(0, 1) == "boundary: 0 visible 13/64 hidden 1/4 visible 1");
  CHECK(e(0, 2) == "boundary: 0 visible 52/265 hidden 8/33 visible 1");
  CHECK(e(1, 2) == "boundary: 0 visible 1");
  for (const auto& [a, b] : {std::pair{3U, 4U}, {3U, 5U}, {6U, 7U}, {6U, 8U}}) {
    INFO(a << "-" << b);
    const std::string text = e.intervals(a, b);
    CHECK(text.find("0 visible ") == 0);
    CHECK(text.find(" hidden ") != std::string::npos);
    CHECK(text.find(" visible 1") != std::string::npos);
  }
  CHECK(e(4, 5) == "boundary: 0 visible 1");
  CHECK(e(7, 8) == "boundary: 0 visible 1");
}

TEST_CASE("two triangles with the same image that pass through each other", "[lines][nasty]") {  // 2
  const auto e = checked(from_top({{{{-2, -2, -2}, {2, -2, 2}, {0, 3, 0}}}, {{{-2, -2, 2}, {2, -2, -2}, {0, 3, 0}}}}));
  // Whatever is drawn of the outline lies in front: each edge hides the other's where it is nearer.
  CHECK(e(0, 1) == "boundary: 0 hidden 1/2 visible 1");
  CHECK(e(3, 4) == "boundary: 0 visible 1/2 hidden 1");
  CHECK(e(0, 2) == "boundary: 0 hidden 1");
  CHECK(e(1, 2) == "boundary: 0 visible 1");
  CHECK(e(2, 3) == "boundary: 0 visible 1");
  CHECK(e(2, 4) == "boundary: 0 hidden 1");
}

TEST_CASE("coincident depth does not hide", "[lines][nasty][H3][H6][H10]") {  // 3
  SECTION("an exact duplicate, and one the other way round: a sheet without thickness") {
    const Polygon triangle{{{0, 0, 0}, {4, 0, 1}, {0, 4, 2}}}, flipped{{{0, 4, 2}, {4, 0, 1}, {0, 0, 0}}};
    for (const auto& view :
         {scenes::from_direction(top), scenes::from_direction({1, -1, 1}), scenes::from_eye({3, 3, 9}, {1, 1, 0})}) {
      const auto e = checked(seen_from(view, {triangle, triangle, flipped}));
      CHECK(e(0, 1) == "boundary: 0 visible 1");
      CHECK(e(0, 2) == "boundary: 0 visible 1");
      CHECK(e(1, 2) == "boundary: 0 visible 1");
      CHECK(e.edges().size() == 3);
    }
  }
  SECTION("coplanar faces that overlap in part") {
    const auto e =
        checked(from_top({{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}}, {{{2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}}}}));
    for (const auto& edge : e.edges()) CHECK(oracle::intervals_text(edge).find("hidden") == std::string::npos);
    // Two edges of each run into the other face: there they are smooth, and lines of their own.
    CHECK(e.edges().size() == 12);
  }
}

TEST_CASE("one subnormal decides between two faces", "[lines][nasty][E2]") {  // 4
  const double tiny = 5e-324;
  const auto e = checked(from_top({{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, 0, tiny}, {4, 0, tiny}, {0, 4, tiny}}}},
                                  {{{{1, -1, 0}, {1, 5, 0}}}, {{{1, -1, tiny}, {1, 5, tiny}}}}));
  CHECK(e(0, 1) == "boundary: 0 hidden 1");
  CHECK(e(0, 2) == "boundary: 0 hidden 1");
  CHECK(e(1, 2) == "boundary: 0 hidden 1");
  CHECK(e(3, 4) == "boundary: 0 visible 1");
  CHECK(e(3, 5) == "boundary: 0 visible 1");
  CHECK(e(4, 5) == "boundary: 0 visible 1");
  CHECK(e(6, 7) == "wire: 0 visible 1/6 hidden 2/3 visible 1");
  CHECK(e(8, 9) == "wire: 0 visible 1");
}

// Two slopes that meet in the ridge 0-1.
std::vector<Polygon> roof() {
  return {{{{0, -1, 1}, {0, 1, 1}, {-2, 1, 0}, {-2, -1, 0}}}, {{{0, 1, 1}, {0, -1, 1}, {2, -1, 0}, {2, 1, 0}}}};
}

TEST_CASE("a roof does not hide its ridge and has no crack", "[lines][nasty][H2]") {  // 5
  const auto e = checked(from_top(roof(), {{{{0, -2, -1}, {0, 2, -1}}},               // exactly behind the ridge
                                           {{{-4, 0, -1}, {4, 0, -1}}},               // across
                                           {{{-4, -4, -1}, {4, 4, -1}}},              // aslant, through the ridge's image
                                           {{{-4, -1, -1}, {4, -1, -1}}}}));  // behind the gable's border, past a shared corner
  CHECK(e(0, 1) == "sharp: 0 visible 1");
  CHECK(e(0, 3) == "boundary: 0 visible 1");
  CHECK(e(8, 9) == "wire: 0 visible 1/4 hidden 3/4 visible 1");
  CHECK(e(10, 11) == "wire: 0 visible 1/4 hidden 3/4 visible 1");
  CHECK(e(12, 13) == "wire: 0 visible 3/8 hidden 5/8 visible 1");
  CHECK(e(14, 15) == "wire: 0 visible 1/4 hidden 3/4 visible 1");
}

const Polygon floor_square{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};

TEST_CASE("touching is not piercing", "[lines][nasty][H10]") {  // 6
  SECTION("a vertex touches a face from above") {
    const auto e = checked(from_top({floor_square, {{{2, 2, 0}, {1, 1, 2}, {3, 1, 2}}}}));
    CHECK(e.intervals(4, 5) == "0 visible 1");
    CHECK(e.intervals(4, 6) == "0 visible 1");
    CHECK(e.intervals(5, 6) == "0 visible 1");
  }
  SECTION("a vertex touches a face from below") {
    const auto e = checked(from_top({floor_square, {{{2, 2, 0}, {1, 1, -2}, {3, 1, -2}}}}));
    CHECK(e.intervals(4, 5) == "0 hidden 1");
    CHECK(e.intervals(4, 6) == "0 hidden 1");
    CHECK(e.intervals(5, 6) == "0 hidden 1");
  }
  SECTION("an edge lies in a face, the rest below") {
    const auto e = checked(from_top({floor_square, {{{1, 1, 0}, {3, 1, 0}, {2, 3, -2}}}}));
    CHECK(e.intervals(4, 5) == "0 visible 1");
    CHECK(e.intervals(4, 6) == "0 hidden 1");
    CHECK(e.intervals(5, 6) == "0 hidden 1");
  }
}

TEST_CASE("a face seen edge-on hides what is behind it in its own plane", "[lines][nasty][H5]") {  // 7
  const Polygon gable{{{-1, 0, 0}, {1, 0, 0}, {0, 0, 2}}};
  SECTION("in a parallel view") {
    const auto e = checked(from_top({gable}, {{{{-2, 0, -1}, {2, 0, -1}}},
                                              {{{-2, 1, -1}, {2, 1, -1}}},
                                              {{{0, -1, -1}, {0, 1, -1}}},
                                              {{{-2, 0, 3}, {2, 0, 3}}},
                                              {{{-2, 0, 0}, {2, 0, 4}}},  // in its plane: enters behind it and comes out
                                              {{{0, 0, -1}, {0, 0, -2}}}}));
    CHECK(e(0, 1) == "boundary: 0 hidden 1");  // its own far edge
    CHECK(e(0, 2) == "boundary: 0 visible 1");
    CHECK(e(1, 2) == "boundary: 0 visible 1");
    CHECK(e(3, 4) == "wire: 0 visible 1/4 hidden 3/4 visible 1");
    CHECK(e(5, 6) == "wire: 0 visible 1");
    CHECK(e(7, 8) == "wire: 0 visible 1");  // only a point of it is behind
    CHECK(e(9, 10) == "wire: 0 visible 1");
    CHECK(e(11, 12) == "wire: 0 visible 1");  // z = x + 2 stays above the slope z = 2x + 2 for x < 0
    CHECK(e(13, 14) == "wire: nothing");
  }
  SECTION("with the eye in its plane") {
    const auto view = scenes::from_eye({0, 0, 3}, {0, 0, 0});
    const auto e = checked(seen_from(view, {gable}, {{{{-2, 0, -1}, {2, 0, -1}}}, {{{-2, 1, -1}, {2, 1, -1}}}}));
    CHECK(e(0, 1) == "boundary: 0 hidden 1");
    CHECK(e(0, 2) == "boundary: 0 visible 1");
    CHECK(e(3, 4) == "wire: 0 visible 1/6 hidden 5/6 visible 1");
    CHECK(e(5, 6) == "wire: 0 visible 1");
  }
}

TEST_CASE("one common image point hides nothing, a common image line does", "[lines][nasty]") {  // 8
  const auto view = scenes::from_eye({0, 0, 0}, {0, 0, 1});
  const Polygon near{{{1, 1, 2}, {2, 1, 2}, {1, 2, 2}}};
  const auto point = checked(seen_from(view, {near, {{{2, 2, 4}, {0, 2, 4}, {2, 0, 4}}}}));
  for (const auto& edge : point.edges()) CHECK(oracle::intervals_text(edge) == "0 visible 1");
  const auto line = checked(seen_from(view, {near, {{{2, 2, 4}, {4, 2, 4}, {3, 0, 4}}}}));
  CHECK(line(3, 4) == "boundary: 0 hidden 1");
  CHECK(line(0, 1) == "boundary: 0 visible 1");
  CHECK(line(3, 5) == "boundary: 0 visible 1");
}

TEST_CASE("of edges that overlap in the image the far one is hidden where they do", "[lines][nasty][H7]") {  // 9
  const auto e = checked(from_top({{{{0, 0, 1}, {4, 0, 1}, {2, 2, 1}}}, {{{2, 0, 0}, {8, 0, 0}, {5, -2, 0}}}}));
  CHECK(e(3, 4) == "boundary: 0 hidden 1/3 visible 1");
  CHECK(e(0, 1) == "boundary: 0 visible 1");
}

TEST_CASE("an edge that ends exactly behind another has no sliver", "[lines][nasty][H7]") {  // 10
  const auto e = checked(from_top({{{{0, 0, 1}, {4, 0, 1}, {2, 2, 1}}}},
                                  {{{{2, 0, 0}, {2, -3, 0}}}, {{{2, 0, 0.5}, {2, 3, 0.5}}}, {{{2, 2, 0}, {2, 5, 0}}}}));
  CHECK(e(3, 4) == "wire: 0 visible 1");
  CHECK(e(5, 6) == "wire: 0 hidden 2/3 visible 1");
  CHECK(e(7, 8) == "wire: 0 visible 1");
}

TEST_CASE("three edges through one image point give equal ends", "[lines][nasty]") {  // 11
  const auto e = checked(
      from_top({{{{-4, 0, 2}, {4, 0, 2}, {0, 4, 2}}}, {{{-3, -3, 1}, {3, 3, 1}, {-3, 3, 1}}}}, {{{{-1, -2, 0}, {1, 2, 0}}}}));
  CHECK(e(6, 7) == "wire: 0 visible 1/2 hidden 1");
  CHECK(e(3, 4) == "boundary: 0 visible 1/2 hidden 5/6 visible 1");
  CHECK(e(0, 1) == "boundary: 0 visible 1");
}

TEST_CASE("edges are cut at the near plane, and what is before it hides nothing", "[lines][nasty][V8][V9]") {  // 12
  const auto view = scenes::from_eye({0, 0, 0}, {0, 0, 4}, 0.25);  // near plane z = 1
  const auto e = checked(seen_from(view,
                                   {{{{-9, -9, -2}, {9, -9, -2}, {0, 9, -2}}},     // behind the eye
                                    {{{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}},  // between the eye and the near plane
                                    {{{8, -1, -3}, {8, 1, -3}, {4, 0, 3}}}},       // passes the eye's plane; z >= 1 stays
                                   {{{{2, 1, -4}, {2, 1, 4}}},                     // through the plane of the eye
                                    {{{-3, 0, 2}, {3, 0, 2}}},
                                    {{{-3, 0, -4}, {3, 0, -4}}},   // antipodal
                                    {{{0, 2, 1}, {2, 2, 1}}},      // in the near plane
                                    {{{0, 3, 1}, {0, 3, -1}}},     // only a point of it is beyond
                                    {{{1, 0, 6}, {25, 0, 6}}}}));  // passes behind the tip: images x/z from 4/3 to 16/3
  CHECK(e(9, 10) == "wire: 5/8 visible 1");
  CHECK(e(11, 12) == "wire: 0 visible 1");
  CHECK(e(13, 14) == "wire: nothing");
  CHECK(e(15, 16) == "wire: 0 visible 1");
  CHECK(e(17, 18) == "wire: nothing");
  CHECK(e(19, 20) == "wire: 0 visible 7/24 hidden 1");
  CHECK(e.intervals(0, 1) == "nothing");
  CHECK(e.intervals(3, 5) == "nothing");
  CHECK(e.intervals(6, 8) == "2/3 visible 1");
}

TEST_CASE("the eye in a face, or on its vertex", "[lines][nasty]") {  // 13
  const auto view = scenes::from_eye({0, 0, 0}, {4, 0, 0}, 0x1p-10);  // near plane x = 1/256
  SECTION("inside a triangle: only directions within its plane are hidden") {
    const auto e = checked(seen_from(view, {{{{-2, -2, 0}, {2, -2, 0}, {0, 4, 0}}}},
                                     {{{{3, -1, 0}, {3, 1, 0}}}, {{{3, -1, 1}, {3, 1, 1}}}, {{{3, -1, -1}, {3, 1, 1}}}}));
    CHECK(e(3, 4) == "wire: 0 hidden 1");
    CHECK(e(5, 6) == "wire: 0 visible 1");
    CHECK(e(7, 8) == "wire: 0 visible 1");
    CHECK(e(1, 2) == "boundary: 0 hidden 511/512");
  }
  SECTION("on a vertex: the edges there are points, the far edge is hidden") {
    const auto e = checked(seen_from(view, {{{{0, 0, 0}, {4, -1, 1}, {4, 1, 1}}}}, {{{{4, -2, 0}, {4, 2, 0}}}}));
    CHECK(e(0, 1) == "boundary: nothing");
    CHECK(e(0, 2) == "boundary: nothing");
    CHECK(e(1, 2) == "boundary: 0 hidden 1");
    CHECK(e(3, 4) == "wire: 0 visible 1");
  }
  SECTION("on an edge") {
    const auto e = checked(seen_from(view, {{{{-1, -1, 0}, {1, 1, 0}, {4, -4, 0}}}}, {{{{5, -5, 0}, {5, 5, 0}}}}));
    CHECK(e(0, 1) == "boundary: nothing");
    CHECK(e(1, 2) == "boundary: 0 hidden 1");
    CHECK(e(3, 4) == "wire: 0 hidden 1");
  }
}

TEST_CASE("the nearer of neighbouring doubles hides, far from a near plane close to the eye", "[lines][nasty]") {  // 14
  const double z = 1e12, next = std::nextafter(z, huge), r = 2e11;
  const auto e =
      checked(seen_from(scenes::from_eye({0, 0, 0}, {0, 0, 1}, 0.001), {{{{-r, -r, z}, {r, -r, z}, {r, r, z}, {-r, r, z}}}},
                        {{{{-2 * r, 0, next}, {2 * r, 0, next}}}, {{{-2 * r, 1, z}, {2 * r, 1, z}}}}));
  const Q from = (Q(2 * r) - Q(r) * Q(next) / Q(z)) / Q(4 * r), to = 1 - from;
  CHECK(e(4, 5) == "wire: 0 visible " + from.get_str() + " hidden " + to.get_str() + " visible 1");
  CHECK(e(6, 7) == "wire: 0 visible 1");
}

TEST_CASE("points that rounding has made one are one", "[lines][nasty]") {  // 17
  const double far = 0x1p53;
  const auto e = checked(from_top({{{{far, 0, 1}, {far + 1, 0, 1}, {far, 1, 1}}}}, {{{{far, -1, 0}, {far, 2, 0}}}}));
  CHECK(e(3, 4) == "wire: 0 visible 1");  // the triangle has no area: it hides nothing, its edges are dropped
  CHECK(e.edges().size() == 1);
}

TEST_CASE("a sliver hides exactly its width", "[lines][nasty]") {  // 18
  const auto e = checked(
      from_top({{{{0, 0, 1}, {1e9, 0, 1}, {0, 1e-7, 1}}}}, {{{{5e8, -1, 0}, {5e8, 1, 0}}}, {{{1e9, -1, 0}, {1e9, 1, 0}}}}));
  const Q to = (1 + Q(1e-7) / 2) / 2;
  CHECK(e(3, 4) == "wire: 0 visible 1/2 hidden " + to.get_str() + " visible 1");
  CHECK(e(5, 6) == "wire: 0 visible 1");  // only the tip
}

TEST_CASE("a plane tilted by 2^-52 shows its face or its back, consistently along the edge", "[lines][nasty]") {  // 18
  const double e52 = 0x1p-52;
  // Nearly edge-on seen from the top: the second face leans under or over the first by one ulp.
  const std::vector<Point3> p = {{0, 0, 0}, {0, 4, 0}, {e52, 0, -4}, {-e52, 0, -4}, {3, 0, 1}};
  const auto lines = [&](std::uint32_t low) {
    TestScene scene;
    scene.points = p;
    scene.add_face({0, 1, 4});
    scene.add_face({0, 1, low});
    scene.view = scenes::from_direction(top);
    return checked(scene);
  };
  CHECK(lines(2)(0, 1) == "outline: 0 visible 1");
  CHECK(lines(3)(0, 1) == "sharp: 0 visible 1");
}

TEST_CASE("m strips over m strips leave 2m(m + 1) pieces of the far long edges", "[lines][nasty]") {  // 19
  constexpr int m = 7;
  std::vector<Polygon> strips;
  for (int i = 0; i < m; ++i) {
    const double a = 2 * i, b = a + 1, end = 2 * m;
    strips.push_back({{{a, -1, 1}, {b, -1, 1}, {b, end, 1}, {a, end, 1}}});
    strips.push_back({{{-1, a, 0}, {end, a, 0}, {end, b, 0}, {-1, b, 0}}});
  }
  const TestScene scene = from_top(strips);
  int pieces = 0;
  const CheckedLines lines = checked(scene);
  for (const auto& e : lines.edges()) {
    const Point3 &a = scene.points[e.a.value], &b = scene.points[e.b.value];
    if (a.z != 0 || a.y != b.y) continue;
    for (std::size_t k = 0; k + 1 < e.cuts.size(); ++k)
      if ((k % 2 != 0) == e.starts_hidden) ++pieces;
  }
  CHECK(pieces == 2 * m * (m + 1));
}

TEST_CASE("three planes through one point", "[lines][nasty]") {  // 23
  const auto e = checked(seen_from(scenes::from_direction({1, 1, 1}),
                                   {{{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}},
                                    {{{-2, 0, -2}, {2, 0, -2}, {2, 0, 2}, {-2, 0, 2}}},
                                    {{{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}}}},
                                   {{{{-2, 0, 0}, {2, 0, 0}}}, {{{0, -2, 0}, {0, 2, 0}}}, {{{0, 0, -2}, {0, 0, 2}}}}));
  for (const std::uint32_t axis : {12U, 14U, 16U}) CHECK(e(axis, axis + 1) == "wire: 0 hidden 1/2 visible 1");
}

TEST_CASE("an edge of any number of faces has the class of the two nearest", "[lines][nasty][C1][C2][C4][C5][C8][C14]") {  // 24
  const auto class_of = [](std::initializer_list<Point3> apexes, const Point3& direction = top) {
    TestScene scene;
    scene.points = {{0, 0, 0}, {0, 4, 0}};
    for (const Point3& apex : apexes) {
      scene.add_face({0, 1, static_cast<std::uint32_t>(scene.points.size())});
      scene.points.push_back(apex);
    }
    scene.view = scenes::from_direction(direction);
    return checked(scene)(0, 1);
  };
  CHECK(class_of({{2, 2, 1}}) == "boundary: 0 visible 1");
  CHECK(class_of({{2, 2, 1}, {2, 2, 3}}) == "outline: 0 visible 1");
  CHECK(class_of({{2, 2, 1}, {4, 1, 2}}) == "boundary: 0 visible 1");  // coinciding half-planes count once
  CHECK(class_of({{2, 2, 1}, {-2, 2, 1}}) == "sharp: 0 visible 1");
  CHECK(class_of({{2, 2, 0}, {-2, 2, 0}}) == "smooth: 0 visible 1");
  CHECK(class_of({{2, 2, 0}, {-2, 2, 0}, {2, 2, -3}, {-1, 2, -2}}) == "smooth: 0 visible 1");
  CHECK(class_of({{2, 2, 1}, {-2, 2, -1}, {3, 2, -1}}) == "smooth: 0 visible 1");
  CHECK(class_of({{2, 2, 1}, {-2, 2, 1}, {3, 2, -1}}) == "sharp: 0 visible 1");
  CHECK(class_of({{2, 2, 1}, {0, 2, -3}}) == "outline: 0 visible 1");  // one is edge-on
  CHECK(class_of({{2, 2, 1}, {0, 2, 3}}) == "outline: 0 hidden 1");    // and before the edge
  CHECK(class_of({{0, 2, -1}}) == "boundary: 0 visible 1");
  CHECK(class_of({{0, 2, 1}, {0, 2, -1}}) == "smooth: 0 hidden 1");  // edge-on all, two half-planes
}

TEST_CASE("a Moebius band", "[lines][nasty]") {  // 24
  TestScene scene;
  scene.points = {{3, 0, 0}, {1, 3, 1}, {-3, 2, -1}, {-3, -2, 1}, {1, -3, -1}};
  for (std::uint32_t i = 0; i < 5; ++i) scene.add_face({i, (i + 1) % 5, (i + 2) % 5});
  for (const Point3& d : {Point3{0, 0, 1}, {1, 0, 0}, {1, 2, 3}, {-1, 1, -1}}) {
    scene.view = scenes::from_direction(d);
    checked(scene);
  }
}

TEST_CASE("triangles without an area hide nothing", "[lines][nasty][F4]") {  // 26
  const auto e = checked(from_top({{{{0, 0, 1}, {4, 0, 1}, {2, 0, 1}}}, {{{0, 1, 1}, {4, 1, 1}, {0, 1, 1}}}, floor_square},
                                  {{{{1, -1, -1}, {1, 5, -1}}}, {{{0, 0, 0.5}, {4, 0, 0.5}}}}));
  CHECK(e(10, 11) == "wire: 0 visible 1/6 hidden 5/6 visible 1");
  CHECK(e(12, 13) == "wire: 0 visible 1");  // the collinear triangle above it is dropped
  CHECK(e(0, 1) == "absent");
  CHECK(e(3, 4) == "absent");
}

TEST_CASE("NaN and infinity are errors, and -0 is 0", "[lines][nasty][R3]") {  // 28
  for (const double bad : {huge, -huge, std::numeric_limits<double>::quiet_NaN()}) {
    TestScene scene = from_top({floor_square});
    scene.points[2].y = bad;
    CHECK_THROWS_AS(scene.mesh(), InputError);
  }
  const auto e = checked(from_top({{{{-0.0, 0, 0}, {4, -0.0, 0}, {4, 4, 0}}}, {{{0, 0, -0.0}, {4, 4, -0.0}, {0.0, 4, 0}}}}));
  CHECK(e.edges().size() == 5);
  CHECK(e(0, 2) == "smooth: 0 visible 1");
}

TEST_CASE("piercing on a contour or at a shared edge changes the status once", "[lines][nasty]") {  // 30
  const auto contour = checked(from_top({floor_square}, {{{{-2, 2, 2}, {2, 2, -2}}}}));
  CHECK(contour(4, 5) == "wire: 0 visible 1/2 hidden 1");
  const auto ridge = checked(from_top(roof(), {{{{-2, 0, 3}, {2, 0, -1}}}}));
  CHECK(ridge(8, 9) == "wire: 0 visible 1/2 hidden 1");
}

}  // namespace
}  // namespace hsr
