#pragma once

#include <array>

#include "geometry/error_bounded.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"

namespace hsr::internal {

/// The parameter t at which `x` cuts pq: 0 at p, 1 at q. @throws PreconditionError if x is parallel to pq. Exact.
Rational parameter_of_cut(const Plane& x, const Point3& p, const Point3& q);

/// The same in doubles with a proven bound; an error that is not finite where they tell nothing.
ErrorBounded bounded_parameter_of_cut(const Plane& x, const Point3& p, const Point3& q);

/// A point that an algorithm makes, kept as what it is made of: an edge cut by a plane, or three planes meeting.
class ConstructedPoint {
 public:
  /// @pre x separates p from q or contains exactly one of them
  static ConstructedPoint on_edge(const Point3& p, const Point3& q, const Plane& x);
  /// @pre the planes meet in one point, a is a span
  static ConstructedPoint meet(const Plane& a, const Plane& b, const Plane& c);

  /// The exact value. @throws PreconditionError where there is no single point
  std::array<Rational, 3> exact() const;
  /// The exact value with each coordinate rounded to the nearest double.
  Point3 rounded() const;

 private:
  bool is_on_edge_ = true;
  Point3 p_, q_;
  std::array<Plane, 3> planes_;
};

/// The common point of three planes in doubles with proven bounds; errors that are not finite where they tell nothing. @pre x
/// is a span
std::array<ErrorBounded, 3> near_meet(const Plane& x, const Plane& y, const Plane& z);

}  // namespace hsr::internal
