#include "geometry/homogeneous_point.h"

#include <catch2/catch.hpp>
#include <random>

using namespace hsr;
using namespace hsr::internal;

TEST_CASE("orientations of points of rationals are those of the rational determinant", "[geometry]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(-2, 2), divisor(1, 3);
  const auto vector = [&] {
    RationalVector p;
    for (Rational& x : p) x = Rational(number(random)) / Rational(divisor(random));
    return p;
  };
  int zeros = 0;
  for (int k = 0; k < 2000; ++k) {
    const RationalVector a = vector(), b = vector(), c = vector(), d = vector();
    const Sign expected = dot(cross(minus(b, a), minus(c, a)), minus(d, a)).sign();
    zeros += expected == Sign::zero ? 1 : 0;
    const HomogeneousPoint3 p = HomogeneousPoint3::of(a), q = HomogeneousPoint3::of(b), r = HomogeneousPoint3::of(c),
                            s = HomogeneousPoint3::of(d);
    CHECK(orientation(p, q, r, s) == expected);
    CHECK(orientation(q, p, r, s) == -expected);
    CHECK(orientation(p, q, HomogeneousPoint3::of_direction(c), s) == dot(cross(minus(b, a), c), minus(d, a)).sign());
  }
  CHECK(zeros > 20);
}

TEST_CASE("orientations of points far apart in size", "[geometry]") {
  const auto at = [](double x, double y, double z) { return HomogeneousPoint3::of({x, y, z}); };
  const HomogeneousPoint3 a = at(1e300, 0, 0), b = at(0, 1e300, 0), c = at(0, 0, 1e300);
  CHECK(orientation(a, b, c, at(0, 0, 0)) == Sign::negative);
  CHECK(orientation(a, b, c, at(1e300, 1e-300, 0)) == Sign::positive);
  CHECK(orientation(a, b, c, at(1e300, -1e-300, 0)) == Sign::negative);
  CHECK(orientation(a, b, c, at(5e299, 5e299, 0)) == Sign::zero);
}
