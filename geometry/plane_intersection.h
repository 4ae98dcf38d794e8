#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/error_bounded.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/predicates.h"

namespace hsr::internal {

/// The line in which two planes meet, and where other planes cut it. It runs along the cross product of their normals.
///
/// Places are told apart by doubles with proven bounds, and by predicates of degree 6 and 9 where these overlap.
class PlaneIntersection {
 public:
  /// Where a plane cuts the line.
  struct Place {
    Plane plane;
    Sign rise = Sign::zero;  ///< how the plane's value changes along the line; zero: it does not, and there is no such place
    ErrorBounded at{0, HUGE_VAL};  ///< one coordinate of it
  };

  /// @pre s and t are spans, and not parallel. @param exact outlives this
  PlaneIntersection(const Plane& s, const Plane& t, Predicates& exact);

  Place place(const Plane& plane) const;
  /// On which side of `plane` a place lies. Exact.
  Sign side(const Plane& plane, const Place& place) const { return exact_.side(plane, s_, t_, place.plane); }
  /// Which of two places comes first along the line: negative, x. Exact.
  Sign order(const Place& x, const Place& y) const;

  std::array<ErrorBounded, 3> bounded_point(const Place& place) const;
  std::array<Rational, 3> exact_point(const Place& place) const;

 private:
  using Vector = std::array<ErrorBounded, 3>;

  Plane s_, t_;
  Predicates& exact_;
  Vector s_normal_, along_;
  ErrorBounded t_at_s_;          // the value of t at the origin of s
  std::size_t axis_ = 0;         // the coordinate that tells places apart
  Sign direction_ = Sign::zero;  // of that coordinate along the line; zero: doubles do not tell
};

}  // namespace hsr::internal
