#pragma once

#include <array>
#include <optional>
#include <span>

namespace hsr::internal {

/// Coordinates relative to any origin.
using SpaceVector = std::array<double, 3>;

/// A circle in space: centre + radius (cos t u + sin t v). u and v are at right angles and of length 1.
struct SpaceCircle {
  SpaceVector centre = {}, u = {}, v = {};
  double radius = 0;

  double distance(const SpaceVector& p) const;  ///< of p from the circle
  double angle(const SpaceVector& p) const;     ///< t of the nearest point
};

/// The circle that points in a row lie on: in the plane by Newell's normal through their centroid the one of least squares; t grows
/// along them. A choice of what is drawn, in doubles; nothing where they are in a line.
///
/// @pre three points or more, in a ring only once around
/// Source: Kasa 1976.
std::optional<SpaceCircle> circle_through(std::span<const SpaceVector> points);

}  // namespace hsr::internal
