#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// A side of a polygon on the paper, and whose it is.
struct PaperSide {
  PaperPoint from, to;
  std::uint32_t owner = 0, ring = 0;
  friend constexpr auto operator<=>(const PaperSide&, const PaperSide&) = default;
};

/// Appends the sides of a closed ring.
void append_sides(std::span<const PaperPoint> ring, std::uint32_t owner, std::vector<PaperSide>& sides,
                  std::uint32_t number = 0);

/// A side whichever way it runs.
struct SideKey {
  PaperPoint low, high;
  std::uint32_t side = 0;
  bool is_reversed = false;

  bool is_at(const SideKey& other) const { return low == other.low && high == other.high; }
};

/// Those between the same two points in a row, in their order among the sides.
std::vector<SideKey> sorted_keys(const std::vector<PaperSide>& sides);

/// Cuts sides so that two which run along each other run between the same two points: a corner that lies on a side, as nearly as
/// rounding allows, becomes a corner of that side, too. The parts of a side take its place, from its start to its end.
///
/// Cost: O(n log n), for sides that are not much longer than most.
std::vector<PaperSide> conforming(const std::vector<PaperSide>& sides);

/// Closed rings of the sides that are left when those that run to and fro between two points cancel each other: together they
/// wind around each place as often as the polygons did, so by the nonzero rule they cover what any of them covers. Sides of no length
/// are left out.
/// @pre each polygon's sides are closed rings
std::vector<std::vector<PaperPoint>> united_rings(const std::vector<PaperSide>& sides);

}  // namespace hsr::internal
