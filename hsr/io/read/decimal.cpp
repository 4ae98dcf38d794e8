#include "hsr/io/read/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace hsr::internal::read {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Both factors of m * 10^k and m / 10^k are doubles here, so that the one rounding is the only one (Clinger 1990).
constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Is the decimal in [p, end) below 1? Decides between underflow and overflow, where its exponent is far from 0.
bool is_small(const char* p, const char* end) {
  long long leading = 0;  // decimal exponent of the first digit that is not 0
  bool point = false, found = false;
  for (; p != end && *p != 'e' && *p != 'E'; ++p) {
    if (*p == '.') {
      point = true;
    } else if (is_digit(*p)) {
      if (*p != '0') found = true;
      if (found && !point) ++leading;
      if (!found && point) --leading;
    }
  }
  if (p == end) return leading <= 0;
  ++p;
  const bool negative = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  long long exponent = 0;
  for (; p != end && is_digit(*p); ++p)
    if (exponent < (1LL << 50)) exponent = 10 * exponent + (*p - '0');
  return leading + (negative ? -exponent : exponent) <= 0;
}

}  // namespace

ScannedDecimal scan_decimal(const char* p, const char* end) {
  const char* const start = p != end && *p == '+' ? p + 1 : p;
  const bool signed_plus = start != p;
  const char* q = start;
  const bool negative = q != end && *q == '-';
  if (negative && signed_plus) return {};
  if (negative) ++q;

  // The short way: up to 19 digits, no exponent.
  const char* const digits = q;
  std::uint64_t mantissa = 0;
  while (q != end && is_digit(*q)) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*q++ - '0');
  std::ptrdiff_t count = q - digits, decimals = 0;
  if (q != end && *q == '.') {
    const char* const point = q++;
    while (q != end && is_digit(*q)) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*q++ - '0');
    decimals = q - point - 1;
    count += decimals;
  }
  if (count == 0) return {};
  const bool exponent = q != end && (*q == 'e' || *q == 'E');
  if (!exponent && count <= 19 && mantissa <= (std::uint64_t{1} << 53) && decimals < std::ssize(powers_of_ten)) {
    const double value = static_cast<double>(mantissa) / powers_of_ten[decimals];
    return {negative ? -value : value, q, Decimal::number};
  }

  ScannedDecimal result;
  const auto [stop, error] = std::from_chars(start, end, result.value);
  if (error == std::errc::invalid_argument) return {};
  result.end = stop;
  result.status = Decimal::number;
  // Some libraries report an infinity or a zero here, others that the result is out of range.
  if (error == std::errc::result_out_of_range || std::isinf(result.value)) {
    if (!is_small(digits, stop)) {
      result.status = Decimal::too_large;
    } else {
      // Below half of the smallest subnormal: correctly rounded, it is 0.
      result.value = negative ? -0.0 : 0.0;
    }
  }
  return result;
}

}  // namespace hsr::internal::read
