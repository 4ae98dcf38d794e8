#pragma once

#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/point.h"

namespace hsr {

/// A point that is known within `error` in each coordinate.
struct BoundedPoint3 {
  Point3 p;
  double error = 0;
};

/// a + t (b - a): the difference, the product and the sum round once each.
inline BoundedPoint3 between(const Point3& a, const Point3& b, const ErrorBounded& t) {
  const auto size = [](const Point3& p) { return std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z))); };
  const Point3 d = {b.x - a.x, b.y - a.y, b.z - a.z};
  const double v = t.value, u = ErrorBounded::u;
  return {{a.x + v * d.x, a.y + v * d.y, a.z + v * d.z},
          (size(d) * (t.error + 4 * u * (1 + std::fabs(v))) + 4 * u * size(a)) * 1.01 + 0x1p-1000};
}

}  // namespace hsr
