#include "hsr/io/read/decimal.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "geometry/number.h"

using namespace hsr;
using namespace hsr::internal::read;

namespace {

ScannedDecimal scan(const std::string& s) { return scan_decimal(s.data(), s.data() + s.size()); }

double value(const std::string& s) {
  const ScannedDecimal d = scan(s);
  REQUIRE(d.status == Decimal::number);
  CHECK(d.end == s.data() + s.size());
  return d.value;
}

/// "mantissa e exponent" as a rational.
Rational exact(const std::string& mantissa, int exponent) {
  const std::string zeros(static_cast<std::size_t>(std::abs(exponent)), '0');
  return Rational::from_string(exponent >= 0 ? mantissa + zeros : mantissa + "/1" + zeros);
}

}  // namespace

TEST_CASE("A decimal number is rounded to the nearest double, halves to even", "[read][decimal][R1]") {
  CHECK(value("0.1") == 0.1);
  CHECK(value("+1.5") == 1.5);
  CHECK(value(".5") == 0.5);
  CHECK(value("5.") == 5);
  CHECK(value("-2E+3") == -2000);
  CHECK(std::signbit(value("-0")));
  // 2^53 + 1 is halfway between two doubles; any digit behind it, however far, decides.
  CHECK(value("9007199254740993") == 9007199254740992.0);
  CHECK(value("9007199254740993." + std::string(300, '0')) == 9007199254740992.0);
  CHECK(value("9007199254740993." + std::string(300, '0') + "1") == 9007199254740994.0);
  CHECK(value("9007199254740992." + std::string(300, '9')) == 9007199254740992.0);
  CHECK(value("9007199254740995") == 9007199254740996.0);
  CHECK(value("8.5e22") == 8.5e22);
  CHECK(value("1" + std::string(400, '0') + "e-400") == 1);
  CHECK(value("0." + std::string(400, '0') + "1e401") == 1);
}

TEST_CASE("What underflows is rounded, what overflows is refused", "[read][decimal][R3]") {
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(value("4.9e-324") == least);
  CHECK(value("2.4703282292062328e-324") == least);  // above half of the least double
  CHECK(value("2.4703282292062327e-324") == 0);
  CHECK(value("2.2250738585072011e-308") == std::bit_cast<double>(std::uint64_t{0x000fffffffffffff}));
  CHECK(value("1e-99999999999999999999") == 0);
  CHECK(std::signbit(value("-1e-400")));
  CHECK(value("0e99999999999999999999") == 0);
  CHECK(value("1.7976931348623158e308") == std::numeric_limits<double>::max());
  CHECK(scan("1.7976931348623159e308").status == Decimal::too_large);
  CHECK(scan("-1e400").status == Decimal::too_large);
  CHECK(scan("1" + std::string(400, '0')).status == Decimal::too_large);
}

TEST_CASE("Only decimal numbers are numbers", "[read][decimal]") {
  for (const char* s : {"", "+", "-", ".", "-.", "e5", "nan", "inf", "-inf", "infinity", "+-1", "-+1", "--1", "x", ",5"}) {
    INFO(s);
    CHECK(scan(s).status == Decimal::malformed);
  }
  const std::string hexadecimal = "0x10", half = "1e", comma = "1,5";
  CHECK(scan(hexadecimal).end == hexadecimal.data() + 1);
  CHECK(scan(half).end == half.data() + 1);
  CHECK(scan(comma).end == comma.data() + 1);
}

TEST_CASE("Random decimals agree with rationals", "[read][decimal][property]") {
  const auto seed = 20240611U;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20000; ++k) {
    std::string digits(1, static_cast<char>('1' + random() % 9));
    for (std::uint64_t n = random() % 30; n != 0; --n) digits += static_cast<char>('0' + random() % 10);
    const int exponent = static_cast<int>(random() % 60) - 30;
    const std::string text = digits + "e" + std::to_string(exponent);
    INFO(text);
    REQUIRE(value(text) == exact(digits, exponent).to_double());
    // The same digits with a point somewhere.
    const std::size_t decimals = random() % digits.size();
    std::string pointed = digits;
    pointed.insert(digits.size() - decimals, ".");
    INFO(pointed);
    REQUIRE(value(pointed) == exact(digits, -static_cast<int>(decimals)).to_double());
  }
}
