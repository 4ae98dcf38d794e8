#include "geometry/constructed_point.h"

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/polynomials.h"

namespace hsr::internal {

namespace {

using Big = BigArithmetic::Number;

struct ValueAndFall {
  Big at_p, fall;
};

/// x at p, and what it falls by from p to q.
ValueAndFall value_and_fall(const Plane& x, const Point3& p, const Point3& q) {
  const BigArithmetic a;
  const Big at_p = polynomials::value(a, x, p), fall = at_p - polynomials::value(a, x, q);
  require(fall != 0, "parameter_of_cut: the plane is parallel to the edge");
  return {at_p, fall};
}

}  // namespace

Rational parameter_of_cut(const Plane& x, const Point3& p, const Point3& q) {
  const ValueAndFall cut = value_and_fall(x, p, q);
  return quotient(cut.at_p, cut.fall);
}

ErrorBounded bounded_parameter_of_cut(const Plane& x, const Point3& p, const Point3& q) {
  const FilterArithmetic a;
  const ErrorBounded at_p = polynomials::value(a, x, p);
  return quotient(at_p, at_p - polynomials::value(a, x, q));
}

ConstructedPoint ConstructedPoint::on_edge(const Point3& p, const Point3& q, const Plane& x) {
  ConstructedPoint c;
  c.p_ = p;
  c.q_ = q;
  c.planes_[0] = x;
  return c;
}

ConstructedPoint ConstructedPoint::meet(const Plane& a, const Plane& b, const Plane& c) {
  ConstructedPoint point;
  point.is_on_edge_ = false;
  point.planes_ = {a, b, c};
  return point;
}

std::array<Rational, 3> ConstructedPoint::exact() const {
  const BigArithmetic a;
  if (is_on_edge_) {
    const ValueAndFall cut = value_and_fall(planes_[0], p_, q_);
    const auto along = [&](int k) -> Rational {
      if (p_[k] == q_[k]) return p_[k];
      return quotient(cut.fall * Big(p_[k]) + cut.at_p * a.difference(q_, p_, k), cut.fall);
    };
    return {along(0), along(1), along(2)};
  }
  const auto d = polynomials::meet_point(a, planes_[0], planes_[1], planes_[2]);
  const Big det = polynomials::meet_value(a, planes_[0], planes_[1], planes_[2]);
  require(det != 0, "ConstructedPoint: the three planes meet in no single point");
  const Point3& o = planes_[0].o;
  return {quotient(det * Big(o.x) + d.x, det), quotient(det * Big(o.y) + d.y, det), quotient(det * Big(o.z) + d.z, det)};
}

std::array<ErrorBounded, 3> near_meet(const Plane& x, const Plane& y, const Plane& z) {
  const FilterArithmetic a;
  const auto d = polynomials::meet_point(a, x, y, z);
  const ErrorBounded det = polynomials::meet_value(a, x, y, z);
  return {ErrorBounded{x.o.x, 0} + quotient(d.x, det), ErrorBounded{x.o.y, 0} + quotient(d.y, det),
          ErrorBounded{x.o.z, 0} + quotient(d.z, det)};
}

Point3 ConstructedPoint::rounded() const {
  const auto p = exact();
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

}  // namespace hsr::internal
