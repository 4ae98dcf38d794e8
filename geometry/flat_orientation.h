#pragma once

#include <cmath>

#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"
#include "geometry/predicates.h"

namespace hsr::internal {

/// A sign of component `axis` of (b - a) x (c - a) that is certainly right, or zero where doubles cannot tell.
///
/// With u = 2^-53 each difference carries a relative error of at most u, each product one more rounding, so a product is off by
/// at most (3u + 3u^2 + u^3) of its exact magnitude, and by at most 2^-1075 more if it underflows. The last subtraction adds u
/// of the result. Together |error| <= 4u (1 + 4u)(|l| + |r|) + 2^-1073 for the computed l and r. 4u < 4.45e-16; 4.6e-16 pays
/// for the roundings of the bound itself, 1e-300 for underflow. An overflow makes the bound infinite or the difference NaN:
/// zero.
inline Sign certain_normal_sign(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const int i = axis == 2 ? 0 : axis + 1;
  const int j = axis == 0 ? 2 : axis - 1;
  const double l = (b[i] - a[i]) * (c[j] - a[j]);
  const double r = (b[j] - a[j]) * (c[i] - a[i]);
  const double difference = l - r;
  const double bound = 4.6e-16 * (std::fabs(l) + std::fabs(r)) + 1e-300;
  return difference > bound ? Sign::positive : difference < -bound ? Sign::negative : Sign::zero;
}

/// The sign of component `axis` of (b - a) x (c - a): the orientation of abc with that coordinate dropped. Exact.
inline Sign normal_sign(const Point3& a, const Point3& b, const Point3& c, int axis, Predicates& predicates) {
  const Sign certain = certain_normal_sign(a, b, c, axis);
  // det(b - a, e, c - a) = -e . (b - a) x (c - a) for the unit vector e of the axis.
  return certain != Sign::zero ? certain : -predicates.side(Plane::along_axis(a, b, axis), c);
}

/// Whether a, b and c are not on one line. Exact.
inline bool has_area(const Point3& a, const Point3& b, const Point3& c, Predicates& predicates) {
  for (int axis = 0; axis < 3; ++axis)
    if (certain_normal_sign(a, b, c, axis) != Sign::zero) return true;
  for (int axis = 0; axis < 3; ++axis)
    if (predicates.side(Plane::along_axis(a, b, axis), c) != Sign::zero) return true;
  return false;
}

/// Whether the way from a to c turns back exactly on itself at b. @pre a != b, b != c
inline bool is_spike(const Point3& a, const Point3& b, const Point3& c, Predicates& predicates) {
  if (a == c) return true;
  // On one line, a and c are on the same side of b in every coordinate that tells a from b.
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return (a[axis] < b[axis]) == (c[axis] < b[axis]) && !has_area(a, b, c, predicates);
  return false;
}

}  // namespace hsr::internal
