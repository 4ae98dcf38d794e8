#include "geometry/constructed_point.h"

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"

namespace hsr {

Rational parameter_of_cut(const Plane& x, const Point3& p, const Point3& q) {
  const RationalArithmetic a;
  const Rational at_p = polynomials::value(a, x, p), at_q = polynomials::value(a, x, q);
  require(at_p != at_q, "parameter_of_cut: the plane is parallel to the edge");
  return at_p / (at_p - at_q);
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
  if (is_on_edge_) {
    const Rational t = parameter_of_cut(planes_[0], p_, q_);
    std::array<Rational, 3> r;
    for (int k = 0; k < 3; ++k) r[static_cast<std::size_t>(k)] = Rational(p_[k]) + t * (Rational(q_[k]) - Rational(p_[k]));
    return r;
  }
  const RationalArithmetic a;
  const auto d = polynomials::meet_point(a, planes_[0], planes_[1], planes_[2]);
  const Rational det = polynomials::meet_value(a, planes_[0], planes_[1], planes_[2]);
  require(det.sign() != Sign::zero, "ConstructedPoint: the three planes meet in no single point");
  const Point3& o = planes_[0].o;
  return {Rational(o.x) + d.x / det, Rational(o.y) + d.y / det, Rational(o.z) + d.z / det};
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

}  // namespace hsr
