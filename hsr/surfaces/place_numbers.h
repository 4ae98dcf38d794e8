#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/number.h"

namespace hsr::internal {

/// A place in a plane, and its coordinates as the nearest doubles, which decide where they differ.
struct NumberedPlace {
  const std::array<Rational, 2>* exact;
  std::array<double, 2> rounded;
};

/// Numbers of places, from 0 on, equal where the places are. Cost: O(n log n), in doubles but for places that are equal or nearly.
std::vector<std::uint32_t> place_numbers(const std::vector<NumberedPlace>& places);

}  // namespace hsr::internal
