#pragma once

#include <array>

#include "geometry/number.h"
#include "geometry/rational_vector.h"

namespace hsr::internal {

/// A point of rationals in homogeneous whole numbers: (h[0], h[1], h[2]) / h[3], h[3] > 0; or a direction, h[3] = 0. Signs of
/// such points need neither a division nor a greatest common divisor.
struct HomogeneousPoint3 {
  std::array<Rational, 4> h;  ///< each whole

  /// Over the least common denominator.
  static HomogeneousPoint3 of(const RationalVector& p);
  static HomogeneousPoint3 of_direction(const RationalVector& d);
};

/// The sign of det(b - a, c - a, d - a); with a direction for one of them, of its limit far along it. Exact: yes. Cost: 30
/// products.
Sign orientation(const HomogeneousPoint3& a, const HomogeneousPoint3& b, const HomogeneousPoint3& c,
                 const HomogeneousPoint3& d);

}  // namespace hsr::internal
