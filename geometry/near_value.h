#pragma once

#include "geometry/plane.h"
#include "geometry/rational_vector.h"

namespace hsr::internal {

/// The value of a near plane, or of a section in its place, at a point that is no double. Exact. @pre near.kind is Kind::near
inline Rational near_value(const Plane& near, const RationalVector& p) {
  if (near.is_section) return dot(minus(p, rational(near.target)), rational(near.normal));
  const RationalVector eye = rational(near.eye), axis = minus(rational(near.target), eye);
  return dot(minus(p, eye), axis) - Rational(near.k) * dot(axis, axis);
}

}  // namespace hsr::internal
