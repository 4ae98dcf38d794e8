#pragma once

#include "geometry/number.h"
#include "geometry/plane.h"

// The polynomials whose signs the predicates are, written once for every kind of number. An `Arithmetic` A has a type A::Number
// and converts: a.difference(p, q, axis) = p[axis] - q[axis], a.direction(d, axis), a.axis(d, axis) for entries 0 and 1,
// a.scalar(k).

namespace hsr::internal::polynomials {

template <class N>
struct Vector {
  N x, y, z;
};

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class A>
auto difference(const A& a, const Point3& p, const Point3& q) {
  return Vector<typename A::Number>{a.difference(p, q, 0), a.difference(p, q, 1), a.difference(p, q, 2)};
}

template <class A>
auto support(const A& a, const Point3& u, Plane::Support is, const Point3& o) {
  using V = Vector<typename A::Number>;
  if (is == Plane::Support::point) return difference(a, u, o);
  if (is == Plane::Support::direction) return V{a.direction(u, 0), a.direction(u, 1), a.direction(u, 2)};
  return V{a.axis(u, 0), a.axis(u, 1), a.axis(u, 2)};
}

/// The normal of a span, and of the span or the section that a near_line is made of.
template <class A>
auto normal(const A& a, const Plane& x) {
  using V = Vector<typename A::Number>;
  if (x.u_is == Plane::Support::normal) return V{a.direction(x.u, 0), a.direction(x.u, 1), a.direction(x.u, 2)};
  return cross(support(a, x.u, x.u_is, x.o), support(a, x.v, x.v_is, x.o));
}

template <class A>
typename A::Number span_value(const A& a, const Plane& x, const Point3& p) {
  return dot(normal(a, x), difference(a, p, x.o));
}

template <class A>
auto as_direction(const A& a, const Point3& d) {
  return Vector<typename A::Number>{a.direction(d, 0), a.direction(d, 1), a.direction(d, 2)};
}

/// The gradient of the near plane.
template <class A>
auto near_normal(const A& a, const Plane& x) {
  return x.is_section ? as_direction(a, x.normal) : difference(a, x.target, x.eye);
}
/// The near plane's value at the viewpoint: -k |target - eye|^2, or of a section normal . (eye - point); for a direction D toward the
/// viewer the limit normal . D.
template <class A>
typename A::Number near_at_eye(const A& a, const Plane& x) {
  const auto n = near_normal(a, x);
  if (!x.is_section) return -(a.scalar(x.k) * dot(n, n));
  return dot(n, x.eye_is_direction ? as_direction(a, x.eye) : difference(a, x.eye, x.target));
}
template <class A>
typename A::Number near_value(const A& a, const Plane& x, const Point3& p) {
  if (x.is_section) return dot(difference(a, p, x.target), near_normal(a, x));
  return dot(difference(a, p, x.eye), near_normal(a, x)) + near_at_eye(a, x);
}
/// The value at the viewpoint of the span that a near_line is made of.
template <class A>
typename A::Number span_at_eye(const A& a, const Plane& x) {
  return x.eye_is_direction ? dot(normal(a, x), as_direction(a, x.eye)) : span_value(a, x, x.eye);
}

/// x(p), as plane.h defines it.
template <class A>
typename A::Number value(const A& a, const Plane& x, const Point3& p) {
  if (x.kind == Plane::Kind::span) return span_value(a, x, p);
  if (x.kind == Plane::Kind::near) return near_value(a, x, p);
  return near_value(a, x, p) * span_at_eye(a, x) - near_at_eye(a, x) * span_value(a, x, p);
}

/// The gradient of value().
template <class A>
auto gradient(const A& a, const Plane& x) {
  using V = Vector<typename A::Number>;
  if (x.kind == Plane::Kind::span) return normal(a, x);
  if (x.kind == Plane::Kind::near) return near_normal(a, x);
  const V axis = near_normal(a, x);
  const V n = normal(a, x);
  const auto line_at_eye = span_at_eye(a, x), at_eye = near_at_eye(a, x);
  return V{line_at_eye * axis.x - at_eye * n.x, line_at_eye * axis.y - at_eye * n.y, line_at_eye * axis.z - at_eye * n.z};
}

/// x(p) y(q) - x(q) y(p)
template <class A>
typename A::Number cross_value(const A& a, const Plane& x, const Plane& y, const Point3& p, const Point3& q) {
  return value(a, x, p) * value(a, y, q) - value(a, x, q) * value(a, y, p);
}

/// det(n_a, n_b, n_c)
template <class A>
typename A::Number meet_value(const A& a, const Plane& p, const Plane& q, const Plane& r) {
  return dot(gradient(a, p), cross(gradient(a, q), gradient(a, r)));
}

/// The common point of p, q and r relative to p.o, as a vector times meet_value(p, q, r). @pre p is a span
template <class A>
auto meet_point(const A& a, const Plane& p, const Plane& q, const Plane& r) {
  const auto np = gradient(a, p);
  const auto of_q = -value(a, q, p.o), of_r = -value(a, r, p.o);
  const auto i = cross(gradient(a, r), np), k = cross(np, gradient(a, q));
  return Vector<typename A::Number>{of_q * i.x + of_r * k.x, of_q * i.y + of_r * k.y, of_q * i.z + of_r * k.z};
}

/// x at the common point X of p, q and r, times meet_value(p, q, r). For any o, n_p . (X - o) = -p(o) (and so on), so by
/// Cramer's rule X - o = -(p(o) n_q x n_r + q(o) n_r x n_p + r(o) n_p x n_q) / det(n_p, n_q, n_r), and x(X) = x(o) + n_x . (X -
/// o).
/// @pre p is a span
template <class A>
typename A::Number meet_side_value(const A& a, const Plane& x, const Plane& p, const Plane& q, const Plane& r) {
  const bool from_x = x.kind == Plane::Kind::span;  // then x(o) is zero
  const Point3& o = from_x ? x.o : p.o;
  const auto nx = gradient(a, x), np = gradient(a, p), nq = gradient(a, q), nr = gradient(a, r);
  const auto change = value(a, p, o) * dot(nx, cross(nq, nr)) + value(a, q, o) * dot(nx, cross(nr, np)) +
                      value(a, r, o) * dot(nx, cross(np, nq));
  return from_x ? -change : value(a, x, o) * dot(np, cross(nq, nr)) - change;
}

/// The determinant of the rows (p_i, p_j, |p|^2) for p = a - d, b - d, c - d, where i and j are the coordinates after `axis`. On
/// a plane that is not parallel to the axis |p - d|^2 is a function of i and j, equal on a circle of that plane to one that is
/// linear in them, above it outside. So this is the in-circle test in the plane's own metric, and no projected one.
template <class A>
typename A::Number in_circle_value(const A& k, const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis) {
  const auto p = difference(k, a, d), q = difference(k, b, d), r = difference(k, c, d);
  const auto minor = [&](const auto& s, const auto& t) {
    return axis == 0 ? s.y * t.z - s.z * t.y : axis == 1 ? s.z * t.x - s.x * t.z : s.x * t.y - s.y * t.x;
  };
  return dot(p, p) * minor(q, r) + dot(q, q) * minor(r, p) + dot(r, r) * minor(p, q);
}

}  // namespace hsr::internal::polynomials
