#pragma once

#include "geometry/bit_range.h"
#include "geometry/number.h"
#include "geometry/point.h"

namespace hsr::internal {

/// Where d lies to the circle through a, b and c, in the plane of the four, for points under one bit range.
///
///   (1) positive, d is inside, if abc turns counter-clockwise with the coordinate `axis` dropped; negative, if it turns the
///       other way; zero, the four are on one circle
///   (2) the sign is that over the rationals, for every finite input
///
/// Degree 4. Stages as those of Predicates: doubles with a proven bound, 128-bit integers where these suffice, intervals, wider
/// integers, big floats.
class InCircle {
 public:
  /// @param points bit range of every point that will be passed
  explicit InCircle(const BitRange& points);

  /// @pre coplanar, in a plane that is not parallel to the axis
  Sign operator()(const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis) const;

 private:
  int lowest_, bits_;
  double scale_;
};

}  // namespace hsr::internal
