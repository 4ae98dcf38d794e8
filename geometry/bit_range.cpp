#include "geometry/bit_range.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/error.h"
#include "geometry/parallel_fold.h"

namespace hsr {

void BitRange::add(double x) {
  const auto pattern = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<int>((pattern >> 52) & 0x7ff);
  auto mantissa = pattern & 0xfffffffffffffULL;
  if (exponent == 0 && mantissa == 0) return;
  require(exponent != 0x7ff, "BitRange: a finite number expected");
  if (exponent != 0) mantissa |= 1ULL << 52;
  const int place = std::max(exponent, 1) - 1075;  // x = mantissa 2^place
  const int low = place + std::countr_zero(mantissa);
  const int high = place + static_cast<int>(std::bit_width(mantissa));
  const bool first = is_zero();
  lowest = first ? low : std::min(lowest, low);
  highest = first ? high : std::max(highest, high);
}

void BitRange::add(const Point3& p) {
  add(p.x);
  add(p.y);
  add(p.z);
}

void BitRange::add(const BitRange& c) {
  if (c.is_zero()) return;
  const bool first = is_zero();
  lowest = first ? c.lowest : std::min(lowest, c.lowest);
  highest = first ? c.highest : std::max(highest, c.highest);
}

BitRange bit_range(std::span<const Point3> points) {
  return internal::parallel_fold(
      points.size(), BitRange{}, [&](BitRange& all, std::size_t i) { all.add(points[i]); },
      [](BitRange& all, const BitRange& more) { all.add(more); });
}

}  // namespace hsr
