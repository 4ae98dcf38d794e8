#include "geometry/slope.h"

#include "geometry/arithmetics.h"
#include "geometry/polynomials.h"

namespace hsr {

namespace {

/// Every value is affine, so the change is the linear part at q - p.
template <class A>
typename A::Number change(const A& a, const Plane& x, const Point3& p, const Point3& q) {
  using namespace polynomials;
  const auto d = difference(a, q, p);
  if (x.kind == Plane::Kind::span) return dot(normal(a, x), d);
  auto near = dot(d, difference(a, x.target, x.eye));
  if (x.kind == Plane::Kind::near) return near;
  return near * span_value(a, x, x.eye) + near_offset(a, x) * dot(normal(a, x), d);
}

}  // namespace

Sign slope(const Plane& x, const Point3& p, const Point3& q) {
  {
    const CGAL::Protect_FPU_rounding<true> directed;
    const auto s = change(IntervalArithmetic{}, x, p, q);
    if (s.inf() > 0) return Sign::positive;
    if (s.sup() < 0) return Sign::negative;
    if (s.inf() == 0 && s.sup() == 0) return Sign::zero;
  }
  return static_cast<Sign>(static_cast<int>(CGAL::sign(change(BigArithmetic{}, x, p, q))));
}

}  // namespace hsr
