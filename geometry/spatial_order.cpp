#include "geometry/spatial_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace hsr::internal {

namespace {

constexpr int levels = 16;  // of the curve

// Whole numbers from 0 to 2^levels - 1 that rise with the coordinates; how evenly decides no more than the time.
std::vector<std::uint32_t> cells(std::span<const double> x) {
  double size = 0;
  for (const double a : x) size = std::max(size, std::fabs(a));
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  const auto scaled = [&](double a) { return std::ldexp(a, -exponent); };  // below 2
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  std::vector<std::uint32_t> result;
  result.reserve(x.size());
  for (const double a : x) {
    const double part = (scaled(a) - scaled(*low)) / (scaled(*high) - scaled(*low));
    result.push_back(part > 0 ? static_cast<std::uint32_t>(std::min(part, 1.0) * ((1 << levels) - 1)) : 0);
  }
  return result;
}

// How far along the curve a cell lies.
std::uint32_t along_hilbert(std::uint32_t x, std::uint32_t y) {
  std::uint32_t distance = 0;
  for (std::uint32_t side = 1U << (levels - 1); side > 0; side /= 2) {
    const bool right = (x & side) != 0, up = (y & side) != 0;
    distance = 4 * distance + (right ? (up ? 2U : 3U) : (up ? 1U : 0U));
    if (up) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return distance;
}

// A number that looks random: splitmix64.
std::uint64_t mixed(std::uint64_t z) {
  z = (z + 0x9e3779b97f4a7c15U) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const PlacesInPlane& places) {
  const std::vector<std::uint32_t> x = cells(places.x), y = cells(places.y);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto round = static_cast<std::uint64_t>(64 - std::countr_zero(mixed(k) | 1ULL << 63));  // the last is half of all
    keys.emplace_back(round << 32 | along_hilbert(x[k], y[k]), static_cast<std::uint32_t>(k));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, k] : keys) order.push_back(k);
  return order;
}

}  // namespace hsr::internal
