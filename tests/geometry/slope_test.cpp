#include "geometry/slope.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"

namespace hsr {

using namespace internal;

namespace {

TEST_CASE("the slope of a plane is the sign of what its value changes by", "[geometry][slope][property]") {
  std::mt19937_64 random(7);
  const auto number = [&](int family) {
    const double whole = static_cast<double>(random() % 5) - 2;
    const int exponent = static_cast<int>(random() % 2040) - 1070;
    return family == 0 ? whole : family == 1 ? whole * std::ldexp(1.0, exponent) : whole + std::ldexp(whole, -40);
  };
  int zeros = 0;
  for (int k = 0; k < 6000; ++k) {
    const int family = k % 3;
    const auto point = [&] {
      const double x = number(family), y = number(family), z = number(family);
      return Point3{x, y, z};
    };
    const Point3 a = point(), b = point(), c = point(), d = point(), p = point(), q = point();
    const Plane face = Plane::of_face(a, b, c);
    for (const Plane& x :
         {face, Plane::of_sight({d, true}, a, b), Plane::near(d, a, 0.3), Plane::near_line(d, b, 0.25, face)}) {
      const Rational change = polynomials::value(RationalArithmetic{}, x, q) - polynomials::value(RationalArithmetic{}, x, p);
      CHECK(slope(x, p, q) == change.sign());
      zeros += change.sign() == Sign::zero ? 1 : 0;
    }
  }
  CHECK(zeros > 1000);
}

}  // namespace
}  // namespace hsr
