#include "geometry/constructed_point.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"

using namespace hsr;
using namespace hsr::internal;

TEST_CASE("an edge cut by a plane is where it should be", "[geometry][constructed_point]") {
  const Plane x = Plane::of_face({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const auto p = ConstructedPoint::on_edge({0, 0, 0}, {3, 6, 9}, x);
  CHECK(p.exact()[0] == Rational::from_string("1/3"));
  CHECK(p.exact()[1] == Rational::from_string("2/3"));
  CHECK(p.exact()[2] == Rational(1));
  CHECK(p.rounded() == Point3{1.0 / 3, 2.0 / 3, 1});
  CHECK(parameter_of_cut(x, {0, 0, 0}, {3, 6, 9}).to_string() == "1/9");
}

TEST_CASE("three planes meet where they should", "[geometry][constructed_point]") {
  const Plane a = Plane::of_face({1, 0, 0}, {1, 1, 0}, {1, 0, 1}), b = Plane::of_face({0, 2, 0}, {1, 2, 0}, {0, 2, 1});
  const Plane c = Plane::of_face({0, 0, 0}, {3, 0, 1}, {0, 3, 1});  // z = (x + y) / 3
  const auto p = ConstructedPoint::meet(a, b, c);
  CHECK(p.exact()[0] == Rational(1));
  CHECK(p.exact()[1] == Rational(2));
  CHECK(p.exact()[2] == Rational(1));
}

TEST_CASE("a constructed point that does not exist is refused", "[geometry][constructed_point]") {
  const Plane a = Plane::of_face({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), b = Plane::of_face({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  CHECK_THROWS_AS(ConstructedPoint::meet(a, b, a).exact(), PreconditionError);
  CHECK_THROWS_AS(parameter_of_cut(a, {0, 0, 1}, {1, 1, 1}), PreconditionError);
}

TEST_CASE("a constructed point survives every exponent", "[geometry][constructed_point]") {
  const double huge = 0x1p1023, tiny = 5e-324;
  const Plane x = Plane::of_face({tiny, 0, 0}, {tiny, 1, 0}, {tiny, 0, 1});
  const auto p = ConstructedPoint::on_edge({0, 0, 0}, {huge, huge, 0}, x);
  CHECK(p.rounded() == Point3{tiny, tiny, 0});
}
