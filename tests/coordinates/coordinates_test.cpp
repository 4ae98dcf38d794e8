// Coordinates of results against rationals, and hidden points against the oracle.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "hsr/hsr.h"
#include "tests/oracle/visible_lines_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

using oracle::Q;

/// Whether d is the double nearest to q, ties to even: no neighbour of d is nearer, and none as near unless d is even.
bool is_nearest(double d, const Q& q) {
  if (d == 0 && std::signbit(d)) return false;
  constexpr double most = std::numeric_limits<double>::max();
  if (!std::isfinite(d)) {
    const Q limit = Q(most) + (Q(most) - Q(std::nextafter(most, 0.0))) / 2;
    return std::isinf(d) && (d > 0 ? q >= limit : Q(-q) >= limit);
  }
  const auto bits = std::bit_cast<std::uint64_t>(d);
  const Q error = abs(Q(q - Q(d)));
  for (const double other : {std::nextafter(d, -most), std::nextafter(d, most)}) {
    if (other == d) continue;
    const Q other_error = abs(Q(q - Q(other)));
    if (other_error < error || (other_error == error && (bits & 1U) != 0)) return false;
  }
  return true;
}

/// Which coordinates of a point are wrong; empty: none.
std::string wrong(const PaperImage& image, const PlacedPoint& placed, const std::array<Rational, 3>& point) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    if (!is_nearest(placed.space[axis], oracle::exact(point[static_cast<std::size_t>(axis)])))
      text += " space " + std::to_string(axis);
  const std::array<Rational, 2> paper = image(point);
  if (!is_nearest(placed.paper.x, oracle::exact(paper[0]))) text += " x";
  if (!is_nearest(placed.paper.y, oracle::exact(paper[1]))) text += " y";
  return text;
}

LineOptions every_class() {
  LineOptions options;
  options.classes.fill(true);
  return options;
}

constexpr std::uint64_t seeds = 60;

TEST_CASE("the coordinates of segments are correctly rounded, on soups of every kind", "[coordinates][segments]") {
  std::set<EdgeClass> classes;
  std::set<bool> perspectives;
  std::size_t near = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const scenes::TestScene test = family.make(seed);
      const Mesh mesh = test.mesh();
      const SceneView scene(mesh, test.view);
      const PaperImage image(test.view);
      const VisibleLines lines = visible_lines(scene, every_class());
      const std::vector<Segment> all = segments(scene, lines);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(test));
      std::size_t expected = 0;
      for (const Line& line : lines.lines) expected += line.intervals();
      REQUIRE(all.size() == expected);
      for (const Segment& s : all) {
        const Line& line = lines.lines.at(s.line);
        CHECK(s.is_hidden == line.hidden(s.interval));
        CHECK(s.edge_class == line.edge_class);
        CHECK(s.a.is_valid() != line.is_intersection());
        if (line.is_intersection()) CHECK((s.faces.size() == 1 || s.faces.size() == 2));
        REQUIRE(wrong(image, s.from, exact_point(scene, lines, line, s.interval)) == "");
        REQUIRE(wrong(image, s.to, exact_point(scene, lines, line, s.interval + 1)) == "");
        classes.insert(s.edge_class);
        perspectives.insert(test.view.is_perspective());
        near += lines.cuts_of(line)[s.interval].kind == Cut::Kind::near ? 1 : 0;
      }
    }
  CHECK(classes.size() == 6);
  CHECK(perspectives.size() == 2);
  CHECK(near > 0);
}

TEST_CASE("the coordinates of fragments and of pieces are correctly rounded", "[coordinates][polygons]") {
  std::size_t holes = 0, corners = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const scenes::TestScene test = family.make(seed);
      const Mesh mesh = test.mesh();
      const SceneView scene(mesh, test.view);
      const PaperImage image(test.view);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(test));
      const VisibleFragments fragments = visible_fragments(scene);
      const std::vector<PlacedPolygon> placed = polygons(scene, fragments);
      REQUIRE(placed.size() == fragments.fragments.size());
      for (std::size_t k = 0; k < placed.size(); ++k) {
        const Fragment& f = fragments.fragments[k];
        CHECK(placed[k].face == mesh.face_of[first_triangle(f.facet)]);
        REQUIRE(placed[k].rings.size() == f.end_ring - f.first_ring);
        holes += placed[k].rings.size() - 1;
        for (std::size_t r = 0; r < placed[k].rings.size(); ++r) {
          const auto ring = fragments.rings[f.first_ring + r];
          REQUIRE(placed[k].rings[r].size() == ring.size());
          for (std::size_t i = 0; i < ring.size(); ++i, ++corners)
            REQUIRE(wrong(image, placed[k].rings[r][i], exact_point(mesh, test.view, f.facet, ring[i].at)) == "");
        }
      }
      const PaintersOrder order = depth_sort(scene).order;
      const std::vector<PlacedPolygon> pieces = polygons(scene, order);
      std::vector<PaintedPolygon> exact = painted_polygons(scene, order);
      std::erase_if(exact, [](const PaintedPolygon& p) { return p.corners.size() == 2; });  // wires
      REQUIRE(pieces.size() == order.pieces.size());
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        REQUIRE(pieces[k].rings.size() == 1);
        CHECK(pieces[k].face.value == exact[k].face);
        REQUIRE(pieces[k].rings[0].size() == exact[k].corners.size());
        for (std::size_t i = 0; i < exact[k].corners.size(); ++i)
          REQUIRE(wrong(image, pieces[k].rings[0][i], exact[k].corners[i]) == "");
      }
      CHECK(verify(exact, test.view).wrong == 0);
    }
  CHECK(holes > 0);
  CHECK(corners > 1000);
}

/// Compares the occluders of each segment with the oracle's shadows on it; returns how many segments are hidden.
std::size_t check_occluders(const scenes::TestScene& test) {
  std::size_t hidden = 0;
  const Mesh mesh = test.mesh();
  const SceneView scene(mesh, test.view);
  const VisibleLines lines = visible_lines(scene, every_class());
  const oracle::VisibleLinesOracle truth(mesh, test.view);
  for (const Segment& s : segments(scene, lines)) {
    const auto end = [&](std::uint32_t k) {
      const std::array<Rational, 3> p = exact_point(scene, lines, lines.lines[s.line], k);
      return oracle::Vec(oracle::exact(p[0]), oracle::exact(p[1]), oracle::exact(p[2]));
    };
    std::set<FaceId> expected;
    for (const oracle::Shadow& shadow : truth.visibility(end(s.interval), end(s.interval + 1)).shadows)
      expected.insert(mesh.face_of[shadow.triangle]);
    hidden += s.is_hidden ? 1 : 0;
    INFO("line " << s.line << "\n" << scenes::to_text(test));
    const std::vector<FaceId> found = occluders_of(scene, lines, s);
    REQUIRE(std::set<FaceId>(found.begin(), found.end()) == expected);
    REQUIRE(found.size() == expected.size());
    CHECK((found.empty() != s.is_hidden || s.is_behind));
  }
  return hidden;
}

TEST_CASE("the occluders of a segment are the faces whose shadows overlap it", "[coordinates][occluders]") {
  std::size_t hidden = 0;
  for (const char* name : {"triangles", "polygons", "edge_on", "boxes", "around_the_eye", "echoes"})
    for (std::uint64_t seed = 0; seed < seeds; ++seed) hidden += check_occluders(scenes::family(name).make(seed));
  CHECK(hidden > 1000);
}

TEST_CASE("what hides an intersection is found wherever on the face it is", "[coordinates][occluders]") {
  // A long face of several triangles, pierced under a lid at either end and in the middle: no one triangle is at all three.
  scenes::TestScene test;
  test.add_face({Point3{0, 0, 0}, {10, -1, 0}, {20, 0, 0}, {20, 4, 0}, {10, 5, 0}, {0, 4, 0}});
  for (const double x : {0.5, 10.0, 19.0}) {
    test.add_face({Point3{x, 1, -1}, {x, 3, -1}, {x, 3, 1}, {x, 1, 1}});
    test.add_face({Point3{x - 1, 0, 2}, {x + 1, 0, 2}, {x + 1, 4, 2}, {x - 1, 4, 2}});
  }
  test.view = scenes::from_direction({0.125, 0.25, 1});
  CHECK(check_occluders(test) >= 3);
}

/// Corners, points between them, points of the same numbers, and points straight behind corners.
std::vector<Point3> points_to_ask(const scenes::TestScene& test, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point3> points = test.points;
  const auto any = [&]() -> const Point3& { return test.points[random() % test.points.size()]; };
  const Point3& e = test.view.viewpoint.at;
  for (int k = 0; k < 30; ++k) {
    const Point3 &a = any(), &b = any(), &c = any();
    points.push_back({a.x, b.y, c.z});
    points.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2});
    const double s = test.view.is_perspective() ? 2 : 1;
    points.push_back({s * a.x - e.x, s * a.y - e.y, s * a.z - e.z});
  }
  std::erase_if(points, [](const Point3& p) { return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z); });
  return points;
}

TEST_CASE("a point is hidden if the oracle says so", "[coordinates][hidden_points]") {
  std::size_t hidden = 0, seen = 0, before_near = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const scenes::TestScene test = family.make(seed);
      const Mesh mesh = test.mesh();
      const SceneView scene(mesh, test.view);
      const oracle::VisibleLinesOracle truth(mesh, test.view);
      const std::vector<Point3> points = points_to_ask(test, seed);
      const std::vector<bool> found = hidden_points(scene, points);
      REQUIRE(found.size() == points.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        const oracle::Vec p(points[k]), eye(test.view.viewpoint.at);
        Q depth = 1;
        if (test.view.is_perspective()) {
          const oracle::Vec axis = oracle::Vec(test.view.target) - eye;
          depth = dot(p - eye, axis) - Q(test.view.near) * dot(axis, axis);
        }
        bool expected = false;
        for (std::size_t t = 0; t < mesh.triangles.size() && sgn(depth) > 0 && !expected; ++t)
          expected = truth.hides(TriangleId(t), p);
        ++(sgn(depth) <= 0 ? before_near : expected ? hidden : seen);
        INFO(family.name << " " << seed << " point " << points[k].x << " " << points[k].y << " " << points[k].z << "\n"
                         << scenes::to_text(test));
        REQUIRE(found[k] == expected);
        if (k % 16 == 0) CHECK(is_hidden(scene, points[k]) == expected);
      }
    }
  CHECK(hidden > 1000);
  CHECK(seen > 1000);
  CHECK(before_near > 100);
}

TEST_CASE("a point that is not finite is said", "[coordinates][hidden_points]") {
  const scenes::TestScene test = scenes::family("triangles").make(1);
  const Mesh mesh = test.mesh();
  CHECK_THROWS_AS(is_hidden(SceneView(mesh, test.view), {0, std::nan(""), 0}), InputError);
}

}  // namespace
}  // namespace hsr
