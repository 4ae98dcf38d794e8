#pragma once

#include <array>

#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"

namespace hsr {

/// The parameter t at which `x` cuts pq: 0 at p, 1 at q. @throws PreconditionError if x is parallel to pq. Exact.
Rational parameter_of_cut(const Plane& x, const Point3& p, const Point3& q);

/// A point that an algorithm makes, kept as what it is made of: an edge cut by a plane, or three planes meeting.
class ConstructedPoint {
 public:
  /// @pre x separates p from q or contains exactly one of them
  static ConstructedPoint on_edge(const Point3& p, const Point3& q, const Plane& x);
  /// @pre the planes are spans that meet in one point
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

}  // namespace hsr
