#pragma once

#include <array>

#include "geometry/number.h"
#include "geometry/point.h"

namespace hsr::internal {

/// Three rationals: for what is written, and for frames.
using RationalVector = std::array<Rational, 3>;

inline RationalVector rational(const Point3& p) { return {p.x, p.y, p.z}; }
inline RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational dot(const RationalVector& a, const RationalVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace hsr::internal
