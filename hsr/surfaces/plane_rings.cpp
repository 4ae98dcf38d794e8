#include "hsr/surfaces/plane_rings.h"

#include <algorithm>
#include <utility>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

PlanePlace difference(const PlanePlace& a, const PlanePlace& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Whether d comes before e on the way around, counter-clockwise from the direction `first`, which itself comes last.
bool comes_first(const PlanePlace& first, const PlanePlace& d, const PlanePlace& e) {
  const auto half = [&](const PlanePlace& x) {
    const Sign side = cross(first, x).sign();
    if (side != Sign::zero) return side == Sign::positive ? 0 : 2;
    return (first[0] * x[0] + first[1] * x[1]).sign() == Sign::positive ? 3 : 1;
  };
  if (half(d) != half(e)) return half(d) < half(e);
  return cross(d, e).sign() == Sign::positive;
}

}  // namespace

Rational cross(const PlanePlace& a, const PlanePlace& b) { return a[0] * b[1] - a[1] * b[0]; }

std::vector<std::vector<std::size_t>> plane_rings(const std::vector<PlaneSide>& sides) {
  std::vector<std::pair<std::uint32_t, std::size_t>> leaving;  // from which place, ascending
  for (std::size_t k = 0; k < sides.size(); ++k) leaving.emplace_back(sides[k].from_number, k);
  std::sort(leaving.begin(), leaving.end());
  const auto along = [&](std::size_t k) { return difference(*sides[k].to, *sides[k].from); };
  std::vector<char> is_used(sides.size(), 0);
  std::vector<std::vector<std::size_t>> rings;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (is_used[first] != 0) continue;
    auto& ring = rings.emplace_back();
    for (std::size_t k = first; is_used[k] == 0;) {
      is_used[k] = 1;
      ring.push_back(k);
      const std::uint32_t end = sides[k].to_number;
      const auto first_next = std::lower_bound(leaving.begin(), leaving.end(), std::pair(end, std::size_t{0}));
      const auto end_next = std::find_if(first_next, leaving.end(), [&](const auto& leaves) { return leaves.first != end; });
      if (first_next == end_next) throw InvariantError("plane_rings: a side that no other goes on from");
      if (end_next - first_next == 1) {
        k = first_next->second;
        continue;
      }
      const PlanePlace back = difference(*sides[k].from, *sides[k].to);
      k = std::max_element(first_next, end_next, [&](const auto& x, const auto& y) {
            return comes_first(back, along(x.second), along(y.second));
          })->second;
    }
  }
  return rings;
}

}  // namespace hsr::internal
