#include "geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/plane_filter.h"
#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"
#include "geometry/view_plane_polynomials.h"

namespace hsr {

using namespace internal;

namespace {

Sign to_sign(int s) { return static_cast<Sign>(s < 0 ? -1 : s > 0 ? 1 : 0); }
Sign exact_sign(const CGAL::Mpzf& x) { return to_sign(static_cast<int>(CGAL::sign(x))); }
Sign exact_sign(const Rational& x) { return x.sign(); }
Sign exact_sign(__int128 x) { return sign_of(x); }
template <std::size_t L>
Sign exact_sign(const FixedInteger<L>& x) {
  return x.sign();
}

}  // namespace

DecisionCounts& DecisionCounts::operator+=(const DecisionCounts& o) {
  filter += o.filter;
  interval += o.interval;
  narrow += o.narrow;
  fixed += o.fixed;
  big += o.big;
  zero += o.zero;
  return *this;
}

Predicates::Predicates(const BitRange& points, const BitRange& direction, Arithmetic arithmetic)
    : points_(points),
      direction_(direction),
      arithmetic_(arithmetic),
      filter_is_proven_(points.highest <= 100 && direction.highest <= 100),
      is_narrow_(std::abs(points.lowest) <= 1000 && std::abs(direction.lowest) <= 1000),
      width_(std::max({points.bits() + 1, direction.bits(), 1})),
      scale_(is_narrow_ ? std::ldexp(1.0, -points.lowest) : 0),
      direction_scale_(is_narrow_ ? std::ldexp(1.0, -direction.lowest) : 0) {}

template <class Polynomial>
Sign Predicates::staged(const Polynomial& polynomial, bool only_spans, int degree) {
  if (arithmetic_ == Arithmetic::staged || arithmetic_ == Arithmetic::double_only) {
    const ErrorBounded x = polynomial(FilterArithmetic{});
    if (x.is_certain() || arithmetic_ == Arithmetic::double_only) {
      ++counts_.filter;
      const Sign s = sign_of(x.value);
      if (s == Sign::zero) ++counts_.zero;
      return s;
    }
  }
  return beyond_filter(polynomial, only_spans, degree);
}

/// A polynomial of degree d in numbers of at most w bits (differences and directions) with at most 2^12 terms, as all of degree
/// 9 and less have, is smaller than 2^(d w + 12); one bit more for the sign. Those of meets have at most 2^18 terms.
template <class Polynomial>
Sign Predicates::beyond_filter(const Polynomial& polynomial, bool only_spans, int degree) {
  const int bits = only_spans ? degree * width_ + (degree <= 9 ? 13 : 19) : 1 << 20;
  Sign s = Sign::zero;
  if (bits <= 127 && is_narrow_ && arithmetic_ == Arithmetic::staged) {
    s = exact_sign(polynomial(NarrowArithmetic{scale_, direction_scale_}));
    ++counts_.narrow;
    if (s == Sign::zero) ++counts_.zero;
    return s;
  }
  if (arithmetic_ != Arithmetic::rational) {
    const CGAL::Protect_FPU_rounding<true> directed;
    const auto x = polynomial(IntervalArithmetic{});
    if (x.inf() > 0 || x.sup() < 0 || (x.inf() == 0 && x.sup() == 0)) {
      ++counts_.interval;
      s = x.inf() > 0 ? Sign::positive : x.sup() < 0 ? Sign::negative : Sign::zero;
      if (s == Sign::zero) ++counts_.zero;
      return s;
    }
  }
  if (arithmetic_ == Arithmetic::rational)
    s = exact_sign(polynomial(RationalArithmetic{}));
  else if (bits <= 192)
    s = exact_sign(polynomial(FixedArithmetic<3>{points_.lowest, direction_.lowest}));
  else if (bits <= 384)
    s = exact_sign(polynomial(FixedArithmetic<6>{points_.lowest, direction_.lowest}));
  else if (bits <= 768)
    s = exact_sign(polynomial(FixedArithmetic<12>{points_.lowest, direction_.lowest}));
  else
    s = exact_sign(polynomial(BigArithmetic{}));
  ++(arithmetic_ != Arithmetic::rational && bits <= 768 ? counts_.fixed : counts_.big);
  if (s == Sign::zero) ++counts_.zero;
  return s;
}

Sign Predicates::side(const Plane& x, const Point3& p) {
  return staged([&](const auto& a) { return polynomials::value(a, x, p); }, x.kind == Plane::Kind::span, 3);
}

Sign Predicates::side_beyond_filter(const Plane& x, const Point3& p) {
  if (arithmetic_ == Arithmetic::double_only) return side(x, p);
  return beyond_filter([&](const auto& a) { return polynomials::value(a, x, p); }, x.kind == Plane::Kind::span, 3);
}

Sign Predicates::cross(const Plane& x, const Plane& y, const Point3& p, const Point3& q) {
  return staged([&](const auto& a) { return polynomials::cross_value(a, x, y, p, q); },
                x.kind == Plane::Kind::span && y.kind == Plane::Kind::span, 6);
}

namespace {

bool is_span(const Plane& x) { return x.kind == Plane::Kind::span; }

}  // namespace

Sign Predicates::turn(const Plane& a, const Plane& b, const Plane& c) {
  return staged([&](const auto& k) { return polynomials::meet_value(k, a, b, c); }, is_span(a) && is_span(b) && is_span(c), 6);
}

Sign Predicates::side(const Plane& x, const Plane& a, const Plane& b, const Plane& c) {
  require(is_span(a), "Predicates::side: a span expected");
  const Sign meet = turn(a, b, c);
  require(meet != Sign::zero, "Predicates::side: the three planes meet in no single point");
  return meet * staged([&](const auto& k) { return polynomials::meet_side_value(k, x, a, b, c); },
                       is_span(x) && is_span(a) && is_span(b) && is_span(c), 9);
}

namespace {

bool only_spans(const ViewPlane& l) { return l.x.kind == Plane::Kind::span && (!l.is_meet || l.y.kind == Plane::Kind::span); }
/// Of the entries of its line.
int degree(const ViewPlane& l) { return l.is_meet ? 6 : 3; }

}  // namespace

Sign Predicates::side(const Camera& camera, const ViewPlane& l, const Point3& p) {
  if (!l.is_meet) return side(l.x, p);
  return staged([&](const auto& a) { return polynomials::view_value(a, camera, l, p); }, only_spans(l), 6);
}

Sign Predicates::crossing_weight(const Camera& camera, const ViewPlane& l, const ViewPlane& m) {
  return staged([&](const auto& a) { return polynomials::crossing_weight(a, camera, l, m); }, only_spans(l) && only_spans(m),
                degree(l) + degree(m));
}

/// For l through the images of a and b, running from a to b, and m through a: with an eye l x m = a' m(b), a' the ray of a;
/// with a direction (l x m)_k = -D_k m(b).
Sign Predicates::turn(const Camera& camera, const ViewPlane& l, const ViewPlane& m) {
  const Sign w = crossing_weight(camera, l, m);
  if (!camera.eye.is_direction) return -w;
  return w * sign_of(camera.eye.at[largest_axis(camera.eye.at)]);
}

Sign Predicates::side(const Camera& camera, const ViewPlane& n, const ViewPlane& l, const ViewPlane& m) {
  const Sign w = crossing_weight(camera, l, m);
  require(w != Sign::zero, "Predicates::side: the lines are parallel in the image");
  return w * staged([&](const auto& a) { return polynomials::lines_value(a, camera, l, m, n); },
                    only_spans(l) && only_spans(m) && only_spans(n), degree(l) + degree(m) + degree(n));
}

PlaneFilter::PlaneFilter(const Plane& plane, Arithmetic arithmetic) {
  const FilterArithmetic a;
  constexpr double u = ErrorBounded::u;
  if (plane.kind == Plane::Kind::span) {
    const auto s = polynomials::support(a, plane.u, plane.u_is, plane.o),
               t = polynomials::support(a, plane.v, plane.v_is, plane.o);
    const double yz = s.y.value * t.z.value, zy = s.z.value * t.y.value;
    const double zx = s.z.value * t.x.value, xz = s.x.value * t.z.value;
    const double xy = s.x.value * t.y.value, yx = s.y.value * t.x.value;
    nx = yz - zy;
    ny = zx - xz;
    nz = xy - yx;
    ox = plane.o.x;
    oy = plane.o.y;
    oz = plane.o.z;
    slope = 10 * u * std::max({std::fabs(yz) + std::fabs(zy), std::fabs(zx) + std::fabs(xz), std::fabs(xy) + std::fabs(yx)});
    least = 0x1p-900;
  } else {
    // Relative to a point at which the value is known: the eye, where it is near(eye), or zero for a near_line; of a section a point
    // of it, and for a direction of view a point of the line's own plane, where that plane's share is zero.
    const bool is_line = plane.kind == Plane::Kind::near_line;
    const Point3& from = !plane.is_section ? plane.eye : !is_line ? plane.target : plane.eye_is_direction ? plane.o : plane.eye;
    const auto n = polynomials::gradient(a, plane);
    ErrorBounded at_from = {};
    if (!plane.is_section && !is_line) at_from = polynomials::near_at_eye(a, plane);
    if (plane.is_section && is_line && plane.eye_is_direction)
      at_from = polynomials::near_value(a, plane, plane.o) * polynomials::span_at_eye(a, plane);
    nx = n.x.value;
    ny = n.y.value;
    nz = n.z.value;
    ox = from.x;
    oy = from.y;
    oz = from.z;
    offset = at_from.value;
    // Coefficients err by n.error; the differences by u, the products and three sums by at most 4.1 u of the terms.
    slope =
        std::max({n.x.error, n.y.error, n.z.error}) * 1.01 + 6 * u * std::max({std::fabs(nx), std::fabs(ny), std::fabs(nz)});
    least = at_from.error * 1.01 + 6 * u * std::fabs(offset) + 0x1p-900;
    // Nothing bounds k: where products with it might overflow, nothing is certain. Below, n . d stays under 2^902.
    if (!(std::max({std::fabs(nx), std::fabs(ny), std::fabs(nz), std::fabs(offset)}) < 0x1p800)) least = HUGE_VAL;
  }
  if (arithmetic == Arithmetic::double_only) slope = least = 0;
  if (arithmetic == Arithmetic::interval || arithmetic == Arithmetic::rational) least = HUGE_VAL;
}

}  // namespace hsr
