#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/point.h"
#include "geometry/vector3.h"

namespace hsr::internal {

/// A point that is known within `error` in each coordinate; infinite: not known.
struct BoundedPoint2 {
  Point2 p;
  double error = 0;
};
struct BoundedPoint3 {
  Point3 p;
  double error = 0;
};

/// Coordinates with bounds of their own as one point: within the largest of these.
inline BoundedPoint3 bounded_point(const std::array<ErrorBounded, 3>& at) {
  return {{at[0].value, at[1].value, at[2].value}, std::max({at[0].error, at[1].error, at[2].error})};
}

/// a + t (b - a): the difference, the product and the sum round once each.
inline BoundedPoint3 between(const Point3& a, const Point3& b, const ErrorBounded& t) {
  const Point3 d = minus(b, a);
  const double v = t.value, u = ErrorBounded::u;
  return {sum(a, v, d), (norm_max(d) * (t.error + 4 * u * (1 + std::fabs(v))) + 4 * u * norm_max(a)) * 1.01 + 0x1p-1000};
}

}  // namespace hsr::internal
