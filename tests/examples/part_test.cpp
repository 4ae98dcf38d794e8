#include "examples/part.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/bit_range.h"
#include "geometry/number.h"

using hsr::Model;
using hsr::Point3;
using hsr::Rational;

namespace {

Rational side(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  std::array<std::array<Rational, 3>, 3> m;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    m[0][i] = Rational(b[axis]) - Rational(a[axis]);
    m[1][i] = Rational(c[axis]) - Rational(a[axis]);
    m[2][i] = Rational(p[axis]) - Rational(a[axis]);
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

TEST_CASE("each edge of the part has one face on its left and one on its right", "[examples][part]") {
  const Model part = hsr::examples::part();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (std::size_t f = 0; f < part.polygons.size(); ++f) {
    const auto ring = part.polygons[f];
    for (std::size_t k = 0; k < ring.size(); ++k) ++directed[{ring[k], ring[(k + 1) % ring.size()]}];
  }
  for (const auto& [edge, count] : directed) {
    REQUIRE(count == 1);
    REQUIRE(directed.count({edge.second, edge.first}) == 1);
  }
}

TEST_CASE("the part is oriented outward: it has the volume of a gear on a flange", "[examples][part]") {
  const Model part = hsr::examples::part();
  double volume = 0;
  for (std::size_t f = 0; f < part.polygons.size(); ++f) {
    const auto ring = part.polygons[f];
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      const Point3 a = part.points[ring[0]], b = part.points[ring[k]], c = part.points[ring[k + 1]];
      volume += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
    }
  }
  const double pi = std::acos(-1.0);
  const double flange = (116.0 * 116 - (4 - pi) * 12 * 12 - 4 * pi * 5.5 * 5.5) * 10;
  const double neck = pi * 22 * 22 * 16;
  const double body = pi * 48 * 48 * 18 - pi * (37.0 * 37 - 17 * 17) * 8 - 6 * pi * 5.5 * 5.5 * 10;
  const double boss = pi * 17 * 17 * 16;
  const double bore = (pi * 10 * 10 + 6 * 3.4) * 60;
  CHECK(volume == Approx(flange + neck + body + boss - bore).epsilon(0.03));  // the teeth fill about half their ring
}

TEST_CASE("each polygon of the part is exactly planar", "[examples][part]") {
  const Model part = hsr::examples::part();
  for (std::size_t f = 0; f < part.polygons.size(); ++f) {
    const auto ring = part.polygons[f];
    std::set<double> heights;
    for (const auto corner : ring) heights.insert(part.points[corner].z);
    if (heights.size() == 1) continue;
    REQUIRE(ring.size() == 4);
    const auto& p = part.points;
    REQUIRE(side(p[ring[0]], p[ring[1]], p[ring[2]], p[ring[3]]).sign() == hsr::Sign::zero);
  }
}

TEST_CASE("the coordinates of the part are whole multiples of 2^-16 mm", "[examples][part]") {
  const auto bit_range = hsr::bit_range(hsr::examples::part().points);
  CHECK(bit_range.lowest >= -16);
  CHECK(bit_range.bits() <= 23);
}
