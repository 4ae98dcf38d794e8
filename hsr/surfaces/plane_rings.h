#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/number.h"

namespace hsr::internal {

using PlanePlace = std::array<Rational, 2>;

/// A straight side of a region of a plane, the region on its left.
struct PlaneSide {
  const PlanePlace *from, *to;
  std::uint32_t from_number, to_number;  ///< see place_numbers.h
};

Rational cross(const PlanePlace& a, const PlanePlace& b);

/// The rings that the sides make, as numbers of these. Where several leave a place, the next is the first one clockwise from the way
/// back: rings touch and do not cross. @pre as many sides end in each place as begin there
std::vector<std::vector<std::size_t>> plane_rings(const std::vector<PlaneSide>& sides);

}  // namespace hsr::internal
