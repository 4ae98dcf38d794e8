#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hsr::internal {

/// Points of a plane, in doubles.
struct PlacesInPlane {
  std::span<const double> x, y;
};

/// An order in which to insert points one by one, so that each is near the one before it and no order in the input is a bad one:
/// rounds that double, each along a Hilbert curve. The same bits everywhere, and for points multiplied exactly by a power of two.
/// Cost: O(n log n). Source: Amenta, Choi & Rote 2003.
std::vector<std::uint32_t> spatial_order(const PlacesInPlane& places);

}  // namespace hsr::internal
