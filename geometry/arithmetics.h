#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include <cmath>
#include <cstdint>

#include "geometry/error.h"
#include "geometry/error_bounded.h"
#include "geometry/fixed_integer.h"
#include "geometry/point.h"
#include "geometry/rational_arithmetic.h"

// The numbers over which the stages of a predicate evaluate the polynomials of polynomials.h. Not a public header: it costs
// CGAL.

namespace hsr::internal {

struct FilterArithmetic {
  using Number = ErrorBounded;
  static Number difference(const Point3& p, const Point3& q, int axis) {
    const double d = p[axis] - q[axis];
    return {d, ErrorBounded::u * std::fabs(d)};
  }
  static Number direction(const Point3& d, int axis) { return {d[axis], 0}; }
  static Number axis(const Point3& d, int axis) { return {d[axis], 0}; }
  static Number scalar(double k) { return {k, 0}; }
};

struct IntervalArithmetic {
  using Number = CGAL::Interval_nt<false>;  // the rounding mode is held by the caller
  static Number difference(const Point3& p, const Point3& q, int axis) { return Number(p[axis]) - Number(q[axis]); }
  static Number direction(const Point3& d, int axis) { return Number(d[axis]); }
  static Number axis(const Point3& d, int axis) { return Number(d[axis]); }
  static Number scalar(double k) { return Number(k); }
};

struct BigArithmetic {
  using Number = CGAL::Mpzf;
  static Number difference(const Point3& p, const Point3& q, int axis) { return Number(p[axis]) - Number(q[axis]); }
  static Number direction(const Point3& d, int axis) { return Number(d[axis]); }
  static Number axis(const Point3& d, int axis) { return Number(d[axis]); }
  static Number scalar(double k) { return Number(k); }
};

/// n / d, reduced once: where sums and products of BigArithmetic end, instead of rationals that are reduced at each. @pre d is
/// not zero
inline Rational quotient(const CGAL::Mpzf& n, const CGAL::Mpzf& d) {
  Rational x, y;
  n.export_to_mpq_t(x.get());
  d.export_to_mpq_t(y.get());
  return x / y;
}

/// Every coordinate divided by 2^lowest, every entry of a direction by its own power: whole numbers, and no sign changes, since
/// each polynomial of spans is homogeneous in the points and in the direction.
template <std::size_t L>
struct FixedArithmetic {
  using Number = FixedInteger<L>;
  int lowest, direction_lowest;

  Number difference(const Point3& p, const Point3& q, int axis) const { return Number::difference(p[axis], q[axis], lowest); }
  Number direction(const Point3& d, int axis) const { return Number::from_double(d[axis], direction_lowest); }
  static Number axis(const Point3& d, int axis) { return Number(static_cast<std::int64_t>(d[axis])); }
  static Number scalar(double) { throw InvariantError("the near plane has no fixed-width stage"); }
};

/// Scaled integers in a pair of hardware registers, for values below 2^127: as cheap as the filter, and it decides the zeros.
struct NarrowArithmetic {
  using Number = __int128;
  double scale, direction_scale;

  Number difference(const Point3& p, const Point3& q, int axis) const {
    return static_cast<std::int64_t>(p[axis] * scale) - static_cast<std::int64_t>(q[axis] * scale);
  }
  Number direction(const Point3& d, int axis) const { return static_cast<std::int64_t>(d[axis] * direction_scale); }
  static Number axis(const Point3& d, int axis) { return static_cast<std::int64_t>(d[axis]); }
  static Number scalar(double) { throw InvariantError("the near plane has no fixed-width stage"); }
};

}  // namespace hsr::internal
