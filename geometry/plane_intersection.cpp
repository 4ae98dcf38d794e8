#include "geometry/plane_intersection.h"

#include <cmath>

#include "geometry/arithmetics.h"
#include "geometry/constructed_point.h"
#include "geometry/polynomials.h"

namespace hsr::internal {

namespace {

using Bounded = polynomials::Vector<ErrorBounded>;

std::array<ErrorBounded, 3> entries(const Bounded& v) { return {v.x, v.y, v.z}; }
ErrorBounded dot(const std::array<ErrorBounded, 3>& a, const std::array<ErrorBounded, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

PlaneIntersection::PlaneIntersection(const Plane& s, const Plane& t, Predicates& exact) : s_(s), t_(t), exact_(exact) {
  if (exact.arithmetic() != Arithmetic::staged) return;
  const FilterArithmetic a;
  const Bounded ns = polynomials::normal(a, s), nt = polynomials::normal(a, t);
  s_normal_ = entries(ns);
  along_ = entries(polynomials::cross(ns, nt));
  t_at_s_ = t.o == s.o ? ErrorBounded{} : polynomials::dot(nt, polynomials::difference(a, s.o, t.o));
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(along_[k].value) > std::fabs(along_[axis_].value)) axis_ = k;
  if (along_[axis_].is_certain()) direction_ = sign_of(along_[axis_].value);
}

/// As polynomials::meet_point, with what belongs to the line taken from it.
PlaneIntersection::Place PlaneIntersection::place(const Plane& plane) const {
  Place p{plane};
  ErrorBounded rise{0, HUGE_VAL};
  if (direction_ != Sign::zero) {
    const FilterArithmetic a;
    const std::array<ErrorBounded, 3> n = entries(polynomials::gradient(a, plane));
    rise = dot(n, along_);
    const std::size_t i = (axis_ + 1) % 3, k = (axis_ + 2) % 3;
    const ErrorBounded n_x_s = n[i] * s_normal_[k] - n[k] * s_normal_[i];
    const ErrorBounded moved = t_at_s_ * n_x_s + polynomials::value(a, plane, s_.o) * along_[axis_];
    p.at = ErrorBounded{s_.o[static_cast<int>(axis_)], 0} - quotient(moved, rise);
  }
  if (rise.is_certain()) {
    ++exact_.counts().filter;
    p.rise = sign_of(rise.value);
  } else {
    p.rise = exact_.turn(s_, t_, plane);
  }
  return p;
}

Sign PlaneIntersection::order(const Place& x, const Place& y) const {
  const ErrorBounded gap = x.at - y.at;
  if (gap.is_certain()) {
    ++exact_.counts().filter;
    return sign_of(gap.value) * direction_;
  }
  return -(side(x.plane, y) * x.rise);
}

std::array<ErrorBounded, 3> PlaneIntersection::bounded_point(const Place& place) const {
  return near_meet(s_, t_, place.plane);
}

std::array<Rational, 3> PlaneIntersection::exact_point(const Place& place) const {
  return ConstructedPoint::meet(s_, t_, place.plane).exact();
}

}  // namespace hsr::internal
