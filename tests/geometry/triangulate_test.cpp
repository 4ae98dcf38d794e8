#include "geometry/triangulate.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/geometry/polygon_cases.h"

using namespace hsr;
using namespace hsr::internal;
using namespace hsr::test;

namespace {

struct Cut {
  FaceUse use;
  std::vector<FaceTriangle> triangles;

  std::vector<std::array<VertexId, 3>> corners() const {
    std::vector<std::array<VertexId, 3>> c;
    for (const FaceTriangle& t : triangles) c.push_back(t.corners);
    return c;
  }
};

Cut cut(const Points& points, const Ring& polygon) {
  Predicates predicates(bit_range(points));
  Cut result;
  result.use = triangulate(points, polygon, predicates, result.triangles);
  return result;
}

std::array<VertexId, 3> triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {VertexId(a), VertexId(b), VertexId(c)};
}

Vector sum_of_areas(const Points& points, const Cut& c) {
  Vector sum;
  for (const FaceTriangle& t : c.triangles) {
    const Vector area = newell(points, t.corners);
    for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + area[k];
  }
  return sum;
}

// The same polygon, bent out of the xy plane exactly, or moved to another plane exactly.
Points lifted(Points points, double a, double b) {
  for (Point3& p : points) p.z = a * p.x + b * p.y;
  return points;
}

}  // namespace

TEST_CASE("A quad is cut at its lowest-index corner", "[geometry][triangulate][F8]") {
  const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Cut c = cut(square, ring({2, 3, 0, 1}));
  CHECK(c.use == FaceUse::planar);
  CHECK(c.corners() == std::vector{triangle(0, 1, 2), triangle(0, 2, 3)});
  CHECK(c.triangles[0].ring_sides == 0b011);
  CHECK(c.triangles[1].ring_sides == 0b110);

  const Points bent = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  CHECK(cut(bent, ring({2, 3, 0, 1})).use == FaceUse::not_coplanar);
  CHECK(cut(bent, ring({2, 3, 0, 1})).corners() == std::vector{triangle(0, 1, 2), triangle(0, 2, 3)});
}

TEST_CASE("A quad that is concave beside its lowest-index corner is cut at the other diagonal", "[geometry][triangulate][F8]") {
  // An arrow head; the concave corner is at (1, 1).
  const double arrow[4][2] = {{0, 0}, {4, 1}, {0, 2}, {1, 1}};
  const int concave = 3;
  for (const double bend : {0.0, 0.25})
    for (std::size_t lowest = 0; lowest < 4; ++lowest) {
      // The corner `lowest` gets index 0.
      Points points(4);
      for (std::size_t k = 0; k < 4; ++k)
        points[VertexId((k + 4 - lowest) % 4)] = {arrow[k][0], arrow[k][1], k == 1 ? bend : 0};
      const Cut c = cut(points, ring({0, 1, 2, 3}));
      CAPTURE(lowest, bend);
      CHECK(c.use == (bend == 0 ? FaceUse::planar : FaceUse::not_coplanar));
      const bool at_lowest = lowest == concave || lowest == 1;
      CHECK(c.corners() == (at_lowest ? std::vector{triangle(0, 1, 2), triangle(0, 2, 3)}
                                      : std::vector{triangle(1, 2, 3), triangle(1, 3, 0)}));
    }
}

TEST_CASE("A quad with a straight corner is cut at that corner", "[geometry][triangulate]") {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const Cut c = cut(points, ring({0, 1, 2, 3}));
  CHECK(c.use == FaceUse::planar);
  CHECK(c.corners() == std::vector{triangle(1, 2, 3), triangle(1, 3, 0)});
}

TEST_CASE("Repeated corners and spikes collapse", "[geometry][triangulate][F2]") {
  const Points points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {5, 5, 0}, {1, 0, 0}, {3, 0, 0}};
  const auto is_the_triangle = [&](const Ring& r) {
    const Cut c = cut(points, r);
    return c.use == FaceUse::planar && c.triangles.size() == 1 && c.triangles[0].ring_sides == 7;
  };
  CHECK(is_the_triangle(ring({0, 1, 2})));
  CHECK(is_the_triangle(ring({0, 0, 1, 1, 1, 2, 2, 0})));
  CHECK(is_the_triangle(ring({0, 1, 3, 1, 2})));        // a spike outward
  CHECK(is_the_triangle(ring({0, 1, 3, 4, 3, 1, 2})));  // and further
  CHECK(is_the_triangle(ring({3, 1, 2, 0, 1})));        // across the seam
  CHECK(is_the_triangle(ring({0, 5, 1, 2})));           // 1 is on the edge from 0 to 5
  CHECK(is_the_triangle(ring({5, 1, 2, 0})));
}

TEST_CASE("A polygon of no area has no triangles", "[geometry][triangulate]") {
  const Points points = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 1, 0}};
  for (const Ring& r : {Ring{}, ring({0}), ring({0, 1}), ring({0, 0, 0}), ring({0, 1, 2}), ring({2, 0, 1, 2, 1}),
                        ring({0, 1, 0, 1}), ring({0, 1, 3, 0, 3, 1})}) {
    const Cut c = cut(points, r);
    CHECK(c.use == FaceUse::no_area);
    CHECK(c.triangles.empty());
  }
}

TEST_CASE("A face with a hole through a keyhole is one planar face", "[geometry][triangulate][F3][F6]") {
  const Points points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  for (const double slope : {0.0, 0.5}) {
    const Points p = lifted(points, slope, -slope);
    const Ring r = ring({0, 1, 2, 3, 0, 4, 7, 6, 5, 4});
    const Cut c = cut(p, r);
    CHECK(c.use == FaceUse::planar);
    CHECK(c.triangles.size() == 8);
    CHECK(sum_of_areas(p, c)[2] == Rational(24));
    for (const FaceTriangle& t : c.triangles) CHECK(newell(p, t.corners)[2] > 0);
  }
}

TEST_CASE("Two triangles that share a corner are one planar face", "[geometry][triangulate]") {
  const Points points = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-2, -1, 0}};
  const Cut c = cut(points, ring({0, 1, 2, 0, 3, 4}));
  CHECK(c.use == FaceUse::planar);
  REQUIRE(c.triangles.size() == 2);
  CHECK(c.triangles[0].ring_sides == 7);
  CHECK(c.triangles[1].ring_sides == 7);
  CHECK(sum_of_areas(points, c) == newell(points, ring({0, 1, 2, 0, 3, 4})));
}

TEST_CASE("A corner on the border of a triangle keeps it from being an ear", "[geometry][triangulate]") {
  // Corner 5 touches the edge from 8 to 0 from outside.
  const Points points = {{4, 0, 0}, {4, 4, 0},  {-4, 4, 0},  {-4, -4, 0}, {3, -4, 0},
                         {2, 0, 0}, {1, -3, 0}, {-1, -3, 0}, {0, 0, 0}};
  const Cut c = cut(points, ring({8, 0, 1, 2, 3, 4, 5, 6, 7}));
  CHECK(c.use == FaceUse::planar);
  CHECK(c.corners() == std::vector{triangle(0, 1, 2), triangle(4, 5, 6), triangle(8, 0, 2), triangle(8, 2, 3),
                                   triangle(3, 4, 6), triangle(3, 6, 7), triangle(8, 3, 7)});
}

TEST_CASE("A bow tie is cut into triangles that run as it does", "[geometry][triangulate][F7]") {
  // Lopsided, and symmetric: the area vector is zero.
  for (const double width : {1.0, 2.0}) {
    const Points points = {{0, 0, 0}, {width, 0, 0}, {0, 2, 0}, {2, 2, 0}};
    const Cut c = cut(points, ring({0, 1, 2, 3}));
    CHECK(c.use == FaceUse::crosses_itself);
    CHECK(c.corners() == std::vector{triangle(0, 1, 2), triangle(0, 2, 3)});
    CHECK(sum_of_areas(points, c) == newell(points, ring({0, 1, 2, 3})));
  }
}

TEST_CASE("A polygon that runs around twice crosses itself", "[geometry][triangulate]") {
  const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Ring r;
  for (std::size_t k = 0; k < 936; ++k) r.emplace_back(k % 4);
  const Cut c = cut(square, r);
  CHECK(c.use == FaceUse::crosses_itself);
  CHECK(c.corners() == std::vector{triangle(0, 1, 3), triangle(1, 2, 3)});  // each once

  for (const std::size_t turns : {2, 3, 100'000}) {  // of a triangle, whichever corner is first
    Ring around;
    for (std::size_t k = 0; k < 3 * turns; ++k) around.emplace_back((k + 1) % 3);
    const Cut once = cut(square, around);
    CHECK(once.use == FaceUse::crosses_itself);
    CHECK(once.corners() == std::vector{triangle(0, 1, 2)});
    CHECK(once.triangles[0].ring_sides == 7);
  }

  // No corner in any ear, and still the ends overlap: a spiral of more than one turn.
  const Points spiral = {{4, 0, 0}, {0, 4, 0},  {-4, 0, 0}, {0, -4, 0}, {5, -1, 0}, {1, 5, 0},
                         {1, 6, 0}, {7, -1, 0}, {0, -6, 0}, {-6, 0, 0}, {0, 6, 0},  {6, 0, 0}};
  Ring around;
  for (std::size_t k = 0; k < 12; ++k) around.emplace_back(11 - k);
  CHECK(cut(spiral, around).use == FaceUse::crosses_itself);
}

TEST_CASE("The ears of a simple polygon are cut off lowest index first and cover it exactly",
          "[geometry][triangulate][property][F9]") {
  std::mt19937 random(20);
  int simple = 0, straight = 0;
  for (int round = 0; round < 2500; ++round) {
    Points points;
    Ring r;
    if (round % 4 == 0) {
      std::tie(points, r) = star_polygon(random, 5 + round % 8);  // to 12 corners
    } else {
      points = grid_polygon(random, 5 + round % 4, 5);
      for (std::size_t k = 0; k < points.size(); ++k) r.emplace_back(k);
    }
    if (!is_simple(points, r)) continue;
    ++simple;
    if (newell(points, r)[2] < 0) std::reverse(r.begin(), r.end());
    const std::size_t n = r.size();
    for (std::size_t k = 0; k < n; ++k)
      straight += turn(points[r[k]], points[r[(k + 1) % n]], points[r[(k + 2) % n]]) == Sign::zero;
    const auto expected = lowest_ears(points, r);
    REQUIRE(expected.size() == n - 2);
    for (const double slope : {0.0, 3.0}) {
      const Points p = lifted(points, slope, -2 * slope);
      const Cut c = cut(p, r);
      CAPTURE(round, slope);
      REQUIRE(c.use == FaceUse::planar);
      REQUIRE(c.corners() == expected);
      REQUIRE(sum_of_areas(p, c) == newell(p, r));
      // Each edge of the polygon is a side of one triangle, and said to be one.
      std::vector<std::array<VertexId, 2>> sides, edges;
      for (const FaceTriangle& t : c.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          if ((t.ring_sides >> k & 1U) != 0) sides.push_back({t.corners[k], t.corners[(k + 1) % 3]});
      for (std::size_t k = 0; k < n; ++k) edges.push_back({r[k], r[(k + 1) % n]});
      std::sort(sides.begin(), sides.end());
      std::sort(edges.begin(), edges.end());
      REQUIRE(sides == edges);
    }
  }
  CHECK(simple > 500);
  CHECK(straight > 30);
}

TEST_CASE("The triangles of any planar face cover each point as often as the polygon runs around it",
          "[geometry][triangulate][property]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> anywhere(0, 3);
  int planar = 0, touching = 0;
  for (int round = 0; round < 1500; ++round) {
    Points points = grid_polygon(random, 16, 4);
    for (std::size_t k = 0; k < 16; ++k) {
      const std::size_t row = k / 4;
      points[VertexId(k)] = {static_cast<double>(k % 4), static_cast<double>(row), 0};
    }
    Ring r;  // may revisit vertices
    std::uniform_int_distribution<std::size_t> vertex(0, 15);
    for (int k = 0; k < 4 + round % 7; ++k) r.emplace_back(vertex(random));
    const Cut c = cut(points, r);
    CAPTURE(round);
    const Vector normal = newell(points, r);
    for (const FaceTriangle& t : c.triangles) REQUIRE(newell(points, t.corners)[2].sign() != Sign::zero);
    // Whatever it is, the triangles add up to it; only one that comes up again is left out, which takes a vertex that does.
    Ring vertices = r;
    std::sort(vertices.begin(), vertices.end());
    if (std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end()) REQUIRE(sum_of_areas(points, c) == normal);
    if (c.use != FaceUse::planar) {
      REQUIRE((c.use == FaceUse::no_area || !is_simple(points, r)));
      continue;
    }
    ++planar;
    touching += !is_simple(points, r);
    REQUIRE(sum_of_areas(points, c) == normal);
    for (const FaceTriangle& t : c.triangles) REQUIRE(newell(points, t.corners)[2].sign() == normal[2].sign());
    for (int sample = 0; sample < 20; ++sample) {
      const Point3 p{anywhere(random), anywhere(random), 0};
      int covers = 0;
      for (const FaceTriangle& t : c.triangles) {
        auto [a, b, d] = t.corners;
        if (normal[2] < 0) std::swap(a, b);
        covers += in_closed_triangle(points[a], points[b], points[d], p);
      }
      REQUIRE(covers <= 1);
      REQUIRE(covers == std::abs(winding_number(points, r, p)));
    }
  }
  CHECK(planar > 150);
  CHECK(touching > 15);
}

TEST_CASE("Polygons that are not coplanar are cut into as many triangles, each with an area",
          "[geometry][triangulate][property][F7]") {
  std::mt19937 random(22);
  std::uniform_int_distribution<int> height(-3, 3);
  for (int round = 0; round < 500; ++round) {
    auto [points, r] = star_polygon(random, 5 + round % 12);
    if (!is_simple(points, r) || newell(points, r)[2] < 0) continue;  // the origin is outside
    const auto expected = lowest_ears(points, r);
    for (Point3& p : points) p.z = height(random) / 4096.0;  // the Newell normal stays nearest to the z axis
    const Cut c = cut(points, r);
    CAPTURE(round);
    if (c.use == FaceUse::planar) continue;
    REQUIRE(c.use == FaceUse::not_coplanar);
    REQUIRE(c.corners().size() == expected.size());
    REQUIRE(sum_of_areas(points, c) == newell(points, r));
    auto mine = c.corners();  // each from its lowest corner on
    auto theirs = expected;
    for (auto* list : {&mine, &theirs})
      for (auto& t : *list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    REQUIRE(mine == theirs);
  }
}

TEST_CASE("The cut does not change under exact scaling, down to subnormals", "[geometry][triangulate]") {
  std::mt19937 random(23);
  for (int round = 0; round < 100; ++round) {
    auto [points, r] = star_polygon(random, 4 + round % 12);
    if (round % 2 == 1)
      for (Point3& p : points) p.z = static_cast<double>(random() % 5);
    const Cut c = cut(points, r);
    for (const int exponent : {-1074, -1060, -900, 900, 1010}) {
      Points scaled = points;
      for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
      const Cut s = cut(scaled, r);
      CAPTURE(round, exponent);
      REQUIRE(s.use == c.use);
      REQUIRE(s.corners() == c.corners());
    }
  }
}

TEST_CASE("One unit in the last place out of the plane is not coplanar", "[geometry][triangulate]") {
  const double tiny = 5e-324;
  const Points points = {{0, 0, 0}, {1, 0, 0}, {1, 1, tiny}, {0, 1, 0}};
  CHECK(cut(points, ring({0, 1, 2, 3})).use == FaceUse::not_coplanar);
  const Points far = {{0x1p52, 0, 0}, {0x1p52 + 1, 0, 0}, {0x1p52 + 1, 1, 0x1p-60}, {0x1p52, 1, 0}};
  CHECK(cut(far, ring({0, 1, 2, 3})).use == FaceUse::not_coplanar);
}
