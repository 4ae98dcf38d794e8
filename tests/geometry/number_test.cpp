#include "geometry/number.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/bit_range.h"
#include "geometry/error.h"
#include "geometry/fixed_integer.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

Rational power(int k) { return k >= 0 ? Rational(std::ldexp(1.0, k)) : Rational(1) / Rational(std::ldexp(1.0, -k)); }

}  // namespace

TEST_CASE("a rational is rounded to the nearest double, ties to even", "[geometry][number]") {
  const Rational one(1);
  CHECK((one + power(-53)).to_double() == 1);                          // a tie, 1 is even
  CHECK((one + power(-52) + power(-53)).to_double() == 1 + 0x1p-51);   // a tie, the upper is even
  CHECK((one + power(-53) + power(-500)).to_double() == 1 + 0x1p-52);  // just above the tie
  CHECK((one + power(-53) - power(-500)).to_double() == 1);            // just below
  CHECK(Rational::from_string("-1/3").to_double() == -1.0 / 3);
  CHECK(Rational().to_double() == 0);
  CHECK_FALSE(std::signbit(Rational().to_double()));
}

TEST_CASE("rounding is right below the normal doubles and beyond the largest", "[geometry][number]") {
  const Rational least(5e-324), half = least / Rational(2);
  CHECK(half.to_double() == 0);  // a tie, 0 is even
  CHECK((half + power(-1023) * power(-1000)).to_double() == 5e-324);
  CHECK((least + half).to_double() == 2 * 5e-324);
  CHECK((Rational(0x1p-1022) - half).to_double() == 0x1p-1022);
  const Rational most(std::numeric_limits<double>::max());
  CHECK(most.to_double() == std::numeric_limits<double>::max());
  CHECK((most * Rational(2)).to_double() == std::numeric_limits<double>::infinity());
  CHECK((Rational() - most * Rational(4)).to_double() == -std::numeric_limits<double>::infinity());
}

TEST_CASE("every double survives the way to a rational and back", "[geometry][number]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x =
        std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), static_cast<int>(random() % 2000) - 1063);
    if (!std::isfinite(x)) continue;
    CHECK(Rational(x).to_double() == x);
    CHECK((Rational(x) / Rational(3)).to_double() == Approx(x / 3).epsilon(1e-15).margin(5e-324));
  }
}

TEST_CASE("rationals print and parse in lowest terms", "[geometry][number]") {
  CHECK((Rational(6) / Rational(-4)).to_string() == "-3/2");
  CHECK(Rational(3).to_string() == "3");
  CHECK(Rational::from_string("2/4") == Rational(0.5));
  CHECK_THROWS_AS(Rational::from_string("1/0"), PreconditionError);
  CHECK_THROWS_AS(Rational::from_string("0.5"), PreconditionError);
  CHECK_THROWS_AS(Rational(std::nan("")), PreconditionError);
  CHECK_THROWS_AS(Rational(1) / Rational(), PreconditionError);
}

TEST_CASE("decimals are rounded half away from zero and carry no needless zeros", "[geometry][number]") {
  CHECK(Rational(0.0625).to_decimal(3) == "0.063");
  CHECK(Rational(-0.0625).to_decimal(3) == "-0.063");
  CHECK(Rational(0.0005).to_decimal(3) == "0.001");
  CHECK(Rational(0.00049).to_decimal(3) == "0");
  CHECK(Rational(12.5).to_decimal(3) == "12.5");
  CHECK(Rational(-120).to_decimal(3) == "-120");
  CHECK(Rational(9.9996).to_decimal(3) == "10");
  CHECK(Rational(2.5).to_decimal(0) == "3");
}

TEST_CASE("a bit_range bounds what it was given", "[geometry][bit_range]") {
  BitRange c;
  CHECK(c.bits() == 0);
  c.add(0.0);
  CHECK(c.bits() == 0);
  c.add(1.0);
  CHECK((c.lowest == 0 && c.highest == 1));
  c.add(-0.75);
  CHECK((c.lowest == -2 && c.highest == 1));
  c.add(5e-324);
  CHECK((c.lowest == -1074 && c.highest == 1));
  c.add(std::numeric_limits<double>::max());
  CHECK((c.highest == 1024 && c.bits() == 2098));
  CHECK_THROWS_AS(c.add(std::numeric_limits<double>::infinity()), PreconditionError);
}

TEST_CASE("fixed-width integers add and multiply as rationals do", "[geometry][fixed_integer]") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 5000; ++i) {
    const auto number = [&] {
      return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 60)),
                        static_cast<int>(random() % 50));
    };
    const double a = number(), b = number(), c = number();
    const auto exact = [](double x) { return FixedInteger<6>::from_double(x, 0); };
    CHECK((exact(a) * exact(b) - exact(c)).sign() == (Rational(a) * Rational(b) - Rational(c)).sign());
    CHECK((exact(a) + exact(b) - exact(c)).sign() == (Rational(a) + Rational(b) - Rational(c)).sign());
    const double far = std::ldexp(a, static_cast<int>(random() % 150));
    CHECK((FixedInteger<12>::difference(far, b, 0) * FixedInteger<12>::difference(c, a, 0)).sign() ==
          ((Rational(far) - Rational(b)) * (Rational(c) - Rational(a))).sign());
    const auto wide = [](double x) { return FixedInteger<12>::from_double(x, 0); };
    CHECK((wide(a) * wide(b) * wide(c) - wide(far) * wide(b)).sign() ==
          (Rational(a) * Rational(b) * Rational(c) - Rational(far) * Rational(b)).sign());
    CHECK((exact(a) * exact(b) - exact(b) * exact(a)).sign() == Sign::zero);
    CHECK(((exact(a) + exact(c)) * exact(b) - exact(a) * exact(b) - exact(c) * exact(b)).sign() == Sign::zero);
    CHECK(FixedInteger<6>(FixedInteger<3>::from_double(a, 0)).sign() == sign_of(a));
  }
}
