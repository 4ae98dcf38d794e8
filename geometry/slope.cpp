#include "geometry/slope.h"

#include <type_traits>

#include "geometry/arithmetics.h"
#include "geometry/polynomials.h"
#include "geometry/view_plane_polynomials.h"

namespace hsr::internal {

namespace {

/// Every value is affine, so the change is the linear part at q - p.
template <class A>
typename A::Number change(const A& a, const Plane& x, const Point3& p, const Point3& q) {
  using namespace polynomials;
  const auto d = difference(a, q, p);
  if (x.kind == Plane::Kind::span) return dot(normal(a, x), d);
  auto near = dot(d, near_normal(a, x));
  if (x.kind == Plane::Kind::near) return near;
  return near * span_at_eye(a, x) - near_at_eye(a, x) * dot(normal(a, x), d);
}

template <class Change>
Sign sign_of_change(const Change& f) {
  {
    const CGAL::Protect_FPU_rounding<true> directed;
    const auto s = f(IntervalArithmetic{});
    if (s.inf() > 0) return Sign::positive;
    if (s.sup() < 0) return Sign::negative;
    if (s.inf() == 0 && s.sup() == 0) return Sign::zero;
  }
  return static_cast<Sign>(static_cast<int>(CGAL::sign(f(BigArithmetic{}))));
}

}  // namespace

Sign slope(const Plane& x, const Point3& p, const Point3& q) {
  return sign_of_change([&](const auto& a) { return change(a, x, p, q); });
}

Sign slope(const Camera& camera, const ViewPlane& l, const Point3& p, const Point3& q) {
  if (!l.is_meet) return slope(l.x, p, q);
  return sign_of_change([&](const auto& a) {
    using N = typename std::remove_cvref_t<decltype(a)>::Number;
    const N at_x = polynomials::plane_at_eye(a, camera, l.x).at_eye, at_y = polynomials::plane_at_eye(a, camera, l.y).at_eye;
    return N(at_x * change(a, l.y, p, q) - at_y * change(a, l.x, p, q));
  });
}

}  // namespace hsr::internal
