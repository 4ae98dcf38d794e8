#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/rational_vector.h"

namespace hsr::internal {

/// A straight side of a plane region in space, which lies on its left as seen against the region's normal.
struct RegionSide {
  static constexpr std::uint32_t none = 0xffffffffU;
  RationalVector from, to;
  std::uint32_t cut_by = none;  ///< of what keep() cut off: its `name`
};

/// A plane that cuts regions off: its value at a point, and its gradient.
struct CuttingPlane {
  RationalVector gradient;
  Rational offset;

  Rational at(const RationalVector& p) const { return dot(gradient, p) + offset; }
};

/// Leaves of a region what is on the positive side of a plane, which is not parallel to its own. Exact.
/// @param normal of the region, toward whom it is seen from
void keep(const CuttingPlane& plane, std::uint32_t name, const RationalVector& normal, std::vector<RegionSide>& sides);

/// The part of a segment on the closed positive side of a plane; false: a point or nothing.
bool keep(const CuttingPlane& plane, RationalVector& from, RationalVector& to);

}  // namespace hsr::internal
