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

/// Whether two circles are one and go the same way around, to a millionth of their radius.
bool are_one(const SpaceCircle& c, const SpaceCircle& d);

/// A circle by its centre, axis and radius; t is 0 at `from` and grows on the shorter way to `to`. Nothing where `from` is on the axis,
/// or `to` is straight above it.
/// @param axis of length 1
std::optional<SpaceCircle> circle_around(const SpaceVector& centre, const SpaceVector& axis, double radius,
                                         const SpaceVector& from, const SpaceVector& to);

/// The circle that points in a row lie on: in the plane by Newell's normal through their centroid the one of least squares; t grows
/// along them. A choice of what is drawn, in doubles; nothing where they are in a line.
///
/// @pre three points or more, in a ring only once around
/// Source: Kasa 1976.
std::optional<SpaceCircle> circle_through(std::span<const SpaceVector> points);

}  // namespace hsr::internal
