#include "geometry/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "geometry/arithmetics.h"
#include "geometry/ear_cutting.h"
#include "geometry/in_circle.h"
#include "geometry/polynomials.h"
#include "tests/geometry/keyhole_polygons.h"

using namespace hsr;
using namespace hsr::internal;
using namespace hsr::test;

namespace {

using Side = std::array<VertexId, 2>;

std::vector<FaceTriangle> cut(const Points& points, const Ring& polygon, FaceUse expected = FaceUse::planar) {
  Predicates predicates(bit_range(points));
  std::vector<FaceTriangle> triangles;
  CHECK(triangulate(points, polygon, predicates, triangles) == expected);
  return triangles;
}

Vector minus(const Point3& a, const Point3& b) {
  return {Rational(a.x) - Rational(b.x), Rational(a.y) - Rational(b.y), Rational(a.z) - Rational(b.z)};
}
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The sum of the cotangents of the angles at p and d, over the side that their triangles share: positive if that is Delaunay, zero
// if the four are on one circle. In space, for any two triangles of one plane with this normal.
Sign cotangents(const Point3& u, const Point3& w, const Point3& p, const Point3& d, const Vector& normal) {
  const Rational at_p = dot(minus(u, p), minus(w, p)), at_d = dot(minus(w, d), minus(u, d));
  const Rational area_p = dot(cross(minus(u, p), minus(w, p)), normal), area_d = dot(cross(minus(w, d), minus(u, d)), normal);
  REQUIRE(area_p > 0);
  REQUIRE(area_d > 0);
  return (at_p * area_d + at_d * area_p).sign();
}

struct Diagonals {
  std::set<Side> all, tied;  // tied: the corners beside it are on one circle
};

// That the triangles are what constrained_delaunay.h says, by rationals.
Diagonals check(const Points& points, const Ring& polygon, const std::vector<FaceTriangle>& triangles) {
  const Vector normal = newell(points, polygon);
  std::map<Side, VertexId> apex_of_diagonal;
  std::vector<Side> edges, expected;
  Vector area;
  for (const FaceTriangle& t : triangles) {
    const Vector a = newell(points, t.corners);
    for (std::size_t k = 0; k < 3; ++k) {
      area[k] = area[k] + a[k];
      const Side side = {t.corners[k], t.corners[(k + 1) % 3]};
      if ((t.ring_sides >> k & 1U) != 0)
        edges.push_back(side);
      else
        REQUIRE(apex_of_diagonal.emplace(side, t.corners[(k + 2) % 3]).second);
    }
  }
  CHECK(area == normal);
  for (std::size_t k = 0; k < polygon.size(); ++k) expected.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  std::sort(edges.begin(), edges.end());
  std::sort(expected.begin(), expected.end());
  CHECK(edges == expected);
  Diagonals diagonals;
  for (const auto& [side, apex] : apex_of_diagonal) {
    const auto other = apex_of_diagonal.find({side[1], side[0]});
    REQUIRE(other != apex_of_diagonal.end());
    if (side[0] > side[1]) continue;
    const Sign sum = cotangents(points[side[0]], points[side[1]], points[apex], points[other->second], normal);
    CHECK(sum != Sign::negative);
    diagonals.all.insert(side);
    if (sum == Sign::zero) diagonals.tied.insert(side);
  }
  return diagonals;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Peer = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<VertexId, Kernel>,
                                                 CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

// The edges that CGAL's constrained Delaunay triangulation has inside a polygon of the xy plane: those which are no edge of it and
// whose middle it runs around.
std::set<Side> diagonals_of_peer(const Points& points, const Ring& polygon) {
  Peer peer;
  std::map<VertexId, Peer::Vertex_handle> handles;
  for (const VertexId v : polygon) {
    if (handles.count(v) != 0) continue;
    handles[v] = peer.insert({points[v].x, points[v].y});
    handles[v]->info() = v;
  }
  for (std::size_t k = 0; k < polygon.size(); ++k)
    peer.insert_constraint(handles[polygon[k]], handles[polygon[(k + 1) % polygon.size()]]);
  std::set<Side> diagonals;
  for (auto e = peer.finite_edges_begin(); e != peer.finite_edges_end(); ++e) {
    if (peer.is_constrained(*e)) continue;
    const VertexId a = e->first->vertex(Peer::cw(e->second))->info(), b = e->first->vertex(Peer::ccw(e->second))->info();
    const Point3 middle{(points[a].x + points[b].x) / 2, (points[a].y + points[b].y) / 2, 0};
    if (winding_number(points, polygon, middle) != 0) diagonals.insert({std::min(a, b), std::max(a, b)});
  }
  return diagonals;
}

// The same up to the choice among corners on one circle.
void compare(const Diagonals& mine, const std::set<Side>& theirs) {
  CHECK(mine.all.size() == theirs.size());
  for (const Side& side : mine.all)
    if (theirs.count(side) == 0) CHECK(mine.tied.count(side) == 1);
  if (mine.tied.empty()) CHECK(mine.all == theirs);
}

// Five times as large and turned by the angle of 3 + 4i, exactly; z is dropped last.
Points turned(const Points& points) {
  Points result = points;
  for (Point3& p : result) p = {5 * p.x, 3 * p.y, 4 * p.y};
  return result;
}

Points sheared(const Points& points, double a, double b) {
  Points result = points;
  for (Point3& p : result) p.z = a * p.x + b * p.y;
  return result;
}

// Around cells of a grid that are taken at random, if one polygon does that: at a vertex where two cells touch it turns either way.
std::pair<Points, Ring> border_of_cells(std::mt19937& random, std::size_t size) {
  std::vector<char> taken(size * size);
  for (char& t : taken) t = random() % 3 != 0;
  const auto is_taken = [&](std::size_t i, std::size_t j) { return i < size && j < size && taken[size * i + j] != 0; };
  Points points;
  for (std::size_t i = 0; i <= size; ++i)
    for (std::size_t j = 0; j <= size; ++j) points.push_back({static_cast<double>(j), static_cast<double>(i), 0});
  const auto at = [&](std::size_t i, std::size_t j) { return VertexId(i * (size + 1) + j); };
  std::multimap<VertexId, VertexId> onward;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      if (!is_taken(i, j)) continue;
      if (!is_taken(i - 1, j)) onward.emplace(at(i, j), at(i, j + 1));
      if (!is_taken(i, j + 1)) onward.emplace(at(i, j + 1), at(i + 1, j + 1));
      if (!is_taken(i + 1, j)) onward.emplace(at(i + 1, j + 1), at(i + 1, j));
      if (!is_taken(i, j - 1)) onward.emplace(at(i + 1, j), at(i, j));
    }
  if (onward.empty()) return {};
  Ring r = {onward.begin()->first};
  for (;;) {
    const auto [first, last] = onward.equal_range(r.back());
    if (first == last) break;
    const auto taken_edge = std::next(first) != last && random() % 2 == 0 ? std::next(first) : first;
    r.push_back(taken_edge->second);
    onward.erase(taken_edge);
  }
  r.pop_back();
  return onward.empty() ? std::pair(points, r) : std::pair<Points, Ring>();
}

}  // namespace

TEST_CASE("Plates of holes have the triangles of CGAL's constrained Delaunay triangulation", "[geometry][delaunay][F9]") {
  std::mt19937 random(30);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const auto [points, polygon] = KeyholePlate(random, 1 + random() % 5, 1 + random() % 5, round % 3 == 0).numbered(random);
    const std::vector<FaceTriangle> triangles = cut(points, polygon);
    REQUIRE(triangles.size() == polygon.size() - 2);
    const Diagonals mine = check(points, polygon, triangles);
    const std::set<Side> theirs = diagonals_of_peer(points, polygon);
    compare(mine, theirs);
    compare(check(turned(points), polygon, cut(turned(points), polygon)), theirs);  // the same circles
    check(sheared(points, 0.5, -3), polygon, cut(sheared(points, 0.5, -3), polygon));
  }
}

TEST_CASE("Random simple polygons have the triangles of CGAL's constrained Delaunay triangulation",
          "[geometry][delaunay][property]") {
  std::mt19937 random(31);
  int compared = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    const auto [points, polygon] = star_polygon(random, 13 + round % 60);
    if (!is_simple(points, polygon) || newell(points, polygon)[2] < 0) continue;
    const Diagonals mine = check(points, polygon, cut(points, polygon));
    compare(mine, diagonals_of_peer(points, polygon));
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("A polygon that has constrained Delaunay triangles is cut off by ears only, and they do not overlap",
          "[geometry][delaunay][property]") {
  std::mt19937 random(32);
  int found = 0;
  std::uniform_real_distribution<double> anywhere(0, 3);
  Points points;
  for (std::size_t k = 0; k < 16; ++k) points.push_back({static_cast<double>(k % 4), static_cast<double>(k / 4), 0});
  Predicates predicates(bit_range(points));
  for (int round = 0; round < 40000; ++round) {
    Ring r;  // a walk over the grid, which may revisit its vertices
    for (int k = 0; k < 5 + round % 12; ++k) {
      VertexId v(random() % 16);
      if (!r.empty() && round % 2 == 0)
        for (int n = 0;
             n < 20 && (v == r.back() || std::hypot(points[v].x - points[r.back()].x, points[v].y - points[r.back()].y) > 1.5);
             ++n)
          v = VertexId(random() % 16);
      r.push_back(v);
    }
    bool is_reduced = true;
    for (std::size_t k = 0; k < r.size(); ++k) {
      const VertexId a = r[k], b = r[(k + 1) % r.size()], c = r[(k + 2) % r.size()];
      is_reduced &= a != b && b != c && !is_spike(points[a], points[b], points[c], predicates);
    }
    if (!is_reduced || newell(points, r)[2] <= 0) continue;
    const FlatPlane plane{points, predicates, 2, Sign::positive};
    const std::vector<FaceTriangle> triangles = constrained_delaunay(plane, r);
    if (triangles.empty()) continue;
    CAPTURE(round);
    ++found;
    REQUIRE(triangles.size() == r.size() - 2);
    check(points, r, triangles);
    const EarCutting ears = cut_ears(plane, r);
    REQUIRE(ears.only_ears);
    REQUIRE(is_free_of_overlap(plane, r, ears.triangles));
    for (int sample = 0; sample < 10; ++sample) {
      const Point3 p{anywhere(random), anywhere(random), 0};
      int covers = 0;
      for (const FaceTriangle& t : triangles)
        covers += in_closed_triangle(points[t.corners[0]], points[t.corners[1]], points[t.corners[2]], p);
      REQUIRE(covers == winding_number(points, r, p));
    }
  }
  CHECK(found > 200);
}

TEST_CASE("Borders of cells of a grid that touch themselves in corners are planar faces of Delaunay triangles",
          "[geometry][delaunay][F3][property]") {
  std::mt19937 random(35);
  int found = 0, touching = 0, of_ears = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto [points, r] = border_of_cells(random, 5);
    if (r.size() < 13) continue;
    CAPTURE(round);
    Predicates predicates(bit_range(points));
    const FlatPlane plane{points, predicates, 2, Sign::positive};
    std::vector<FaceTriangle> triangles;
    if (triangulate(points, r, predicates, triangles) != FaceUse::planar) {  // it crosses itself where it turns in a vertex
      REQUIRE(constrained_delaunay(plane, r).empty());
      continue;
    }
    check(points, r, triangles);
    REQUIRE(is_free_of_overlap(plane, r, triangles));
    ++found;
    touching += !is_simple(points, r);
    of_ears += constrained_delaunay(plane, r).empty();
  }
  CHECK(found > 300);
  CHECK(touching > 100);
  CHECK(of_ears > 10);
}

TEST_CASE("A polygon of which a corner touches an edge is cut by ears, which are then flipped", "[geometry][delaunay]") {
  // A comb; the tip of its last tooth but one touches the bar that comes back above it.
  Points points;
  Ring polygon;
  const auto add = [&](double x, double y) {
    points.push_back({x, y, 0});
    polygon.emplace_back(points.size() - 1);
  };
  add(0, 0);
  add(20, 0);
  add(20, 10);
  add(0, 10);
  add(0, 6);
  add(18, 6);
  for (int tooth = 8; tooth > 0; --tooth) {
    add(2 * tooth, 2);
    add(2 * tooth - 1, tooth == 2 ? 6 : 4);
  }
  add(0, 2);
  Predicates predicates(bit_range(points));
  CHECK(constrained_delaunay({points, predicates, 2, Sign::positive}, polygon).empty());
  const std::vector<FaceTriangle> triangles = cut(points, polygon);
  CHECK(triangles.size() == polygon.size() - 2);
  CHECK(check(points, polygon, triangles).all.size() == polygon.size() - 3);
}

TEST_CASE("The triangles of plates do not change under exact scaling, nor with the numbers of their bits",
          "[geometry][delaunay]") {
  std::mt19937 random(33);
  for (int round = 0; round < 6; ++round) {
    auto [points, polygon] = KeyholePlate(random, 3, 2, round % 2 == 0).numbered(random);
    points = round % 3 == 0 ? turned(points) : sheared(points, 2, 1);
    const auto expected = cut(points, polygon);
    for (const int exponent : {-1070, -900, 900, 1010}) {
      Points scaled = points;
      for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
      const auto found = cut(scaled, polygon);
      CAPTURE(round, exponent);
      REQUIRE(found.size() == expected.size());
      for (std::size_t t = 0; t < found.size(); ++t) REQUIRE(found[t].corners == expected[t].corners);
    }
  }
}

TEST_CASE("in_circle has the sign of the rationals at every range of bits", "[geometry][delaunay][property]") {
  std::mt19937 random(34);
  int zeros = 0;
  for (int round = 0; round < 4000; ++round) {
    std::uniform_int_distribution<int> small(-5, 5);
    std::array<Point3, 4> p;
    const int exponent = std::array{0, -1074, -500, 90, 300, 1015}[static_cast<std::size_t>(round % 6)];
    for (Point3& q : p) {
      const double x = small(random), y = small(random);
      q = {std::ldexp(5 * x, exponent), std::ldexp(3 * y, exponent), std::ldexp(4 * y, exponent)};
      if (round % 5 == 1) q.x += std::ldexp(small(random), exponent < -1000 ? exponent : exponent - 45);  // nearly on a circle
      if (round % 5 == 2) q.x += std::ldexp(small(random), -1074);                                        // up to all bits
    }
    const int axis = static_cast<int>(random() % 2) + 1;
    BitRange range;
    for (const Point3& q : p) range.add(q);
    const Sign expected = polynomials::in_circle_value(RationalArithmetic{}, p[0], p[1], p[2], p[3], axis).sign();
    CAPTURE(round);
    REQUIRE(InCircle(range)(p[0], p[1], p[2], p[3], axis) == expected);
    zeros += expected == Sign::zero;
  }
  CHECK(zeros > 100);
}

TEST_CASE("in_circle is positive inside the circle of the plane, not of its projection", "[geometry][delaunay]") {
  // The circle of radius 25 in a plane that rises by 4 in 3; projected along z, an ellipse.
  const auto at = [](double x, double y) { return Point3{5 * x, 3 * y, 4 * y}; };
  const Point3 a = at(5, 0), b = at(0, 5), c = at(-5, 0);
  BitRange range;
  for (const Point3& p : {a, b, c, at(10, 10)}) range.add(p);
  const InCircle in_circle(range);
  CHECK(in_circle(a, b, c, at(0, -5), 2) == Sign::zero);
  CHECK(in_circle(a, b, c, at(3, -4), 2) == Sign::zero);
  CHECK(in_circle(a, b, c, at(3, -3), 2) == Sign::positive);
  CHECK(in_circle(a, b, c, at(4, -4), 2) == Sign::negative);
  CHECK(in_circle(c, b, a, at(3, -3), 2) == Sign::negative);
}
