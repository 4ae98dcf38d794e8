#include "geometry/rounded_sum.h"

#include <catch2/catch.hpp>
#include <random>

using namespace hsr;
using namespace hsr::internal;

namespace {

double of(const std::vector<Rational>& terms) {
  std::vector<const Rational*> pointers;
  for (const Rational& x : terms) pointers.push_back(&x);
  return rounded_sum(pointers);
}

Rational ratio(double p, double q) { return Rational(p) / Rational(q); }

}  // namespace

TEST_CASE("a rounded sum is the exact one rounded once", "[geometry]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> size(0, 40), magnitude(-60, 60), part(-1000, 1000);
  for (int k = 0; k < 300; ++k) {
    std::vector<Rational> terms;
    Rational sum;
    for (int n = size(random); n > 0; --n) {
      terms.push_back(ratio(part(random), 1 + std::abs(part(random))) * Rational(std::ldexp(1.0, magnitude(random))));
      sum = sum + terms.back();
    }
    CHECK(of(terms) == sum.to_double());
  }
}

TEST_CASE("a rounded sum: ties, cancellation and both ends of the range", "[geometry]") {
  const double half_unit = 0x1p-53;
  CHECK(of({ratio(1, 3), ratio(2, 3), half_unit / 2, half_unit / 2}) == 1);  // a tie: to even
  CHECK(of({ratio(1, 3), ratio(2, 3), half_unit, 0x1p-1000}) == 1 + 2 * half_unit);
  CHECK(of({ratio(1, 3), ratio(2, 3), half_unit, -0x1p-1000}) == 1);
  CHECK(of({ratio(1, 7), -1.0, ratio(6, 7), 0.0}) == 0);
  CHECK(of({ratio(1, 7), -1.0, ratio(6, 7), 0x1p-1074}) == 0x1p-1074);  // all but the last cancel
  CHECK(of({0.0, 0.0, 0.0, 0.0}) == 0);
  CHECK(of({}) == 0);
  CHECK(of({1e308, 1e308, -1e308, ratio(1, 3)}) == 1e308);
}
