#pragma once

#include "geometry/number.h"
#include "geometry/point.h"

namespace hsr::internal {

/// The polynomials of polynomials.h over the rationals.
struct RationalArithmetic {
  using Number = Rational;
  static Number difference(const Point3& p, const Point3& q, int axis) { return Number(p[axis]) - Number(q[axis]); }
  static Number direction(const Point3& d, int axis) { return {d[axis]}; }
  static Number axis(const Point3& d, int axis) { return {d[axis]}; }
  static Number scalar(double k) { return {k}; }
};

}  // namespace hsr::internal
