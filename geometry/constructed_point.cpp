#include "geometry/constructed_point.h"

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
  // Cramer's rule relative to the first plane's origin, as in polynomials::meet_side_value.
  const RationalArithmetic a;
  const auto n0 = polynomials::normal(a, planes_[0]), n1 = polynomials::normal(a, planes_[1]),
             n2 = polynomials::normal(a, planes_[2]);
  const Point3& o = planes_[0].o;
  const Rational d1 = polynomials::dot(n1, polynomials::difference(a, planes_[1].o, o));
  const Rational d2 = polynomials::dot(n2, polynomials::difference(a, planes_[2].o, o));
  const Rational det = polynomials::dot(n0, polynomials::cross(n1, n2));
  require(det.sign() != Sign::zero, "ConstructedPoint: the three planes meet in no single point");
  const auto c1 = polynomials::cross(n2, n0), c2 = polynomials::cross(n0, n1);
  return {Rational(o.x) + (d1 * c1.x + d2 * c2.x) / det, Rational(o.y) + (d1 * c1.y + d2 * c2.y) / det,
          Rational(o.z) + (d1 * c1.z + d2 * c2.z) / det};
}

Point3 ConstructedPoint::rounded() const {
  const auto p = exact();
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

}  // namespace hsr
