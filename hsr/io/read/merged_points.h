#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace hsr::internal::read {

/// Gives equal points one index, that of the first: bit by bit, but -0 equals 0. For formats without indices.
class MergedPoints {
 public:
  explicit MergedPoints(std::vector<Point3>& points) : points_(points), slots_(1024, none) {}

  std::uint32_t index(const Point3& p) {
    if (2 * points_.size() >= slots_.size()) grow();
    std::uint32_t& slot = find(p);
    if (slot == none) {
      slot = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return slot;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  static std::uint64_t hash(const Point3& p) {
    std::uint64_t h = 0;
    for (const double c : {p.x, p.y, p.z}) {
      h ^= std::bit_cast<std::uint64_t>(c + 0.0);  // -0 + 0 is 0
      h *= 0x9e3779b97f4a7c15U;
      h ^= h >> 32;
    }
    return h;
  }
  /// The slot of `p`, or the empty one where it goes. Finite numbers are equal iff their bits are, or they are zeros.
  std::uint32_t& find(const Point3& p) {
    std::size_t at = hash(p) & (slots_.size() - 1);
    while (slots_[at] != none && points_[slots_[at]] != p) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::size_t i = 0; i < points_.size(); ++i) find(points_[i]) = static_cast<std::uint32_t>(i);
  }

  std::vector<Point3>& points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace hsr::internal::read
