#pragma once

#include "geometry/number.h"
#include "geometry/plane.h"

// The polynomials whose signs the predicates are, written once for every kind of number. An `Arithmetic` A has a type A::Number
// and converts: a.difference(p, q, axis) = p[axis] - q[axis], a.direction(d, axis), a.axis(d, axis) for entries 0 and 1,
// a.scalar(k).

namespace hsr::polynomials {

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

/// The normal of a span, and of the span that a near_line is made of.
template <class A>
auto normal(const A& a, const Plane& x) {
  return cross(support(a, x.u, x.u_is, x.o), support(a, x.v, x.v_is, x.o));
}

template <class A>
typename A::Number span_value(const A& a, const Plane& x, const Point3& p) {
  return dot(normal(a, x), difference(a, p, x.o));
}

/// k |target - eye|^2: what the near plane's value at the eye lacks to zero.
template <class A>
typename A::Number near_offset(const A& a, const Plane& x) {
  const auto d = difference(a, x.target, x.eye);
  return a.scalar(x.k) * dot(d, d);
}
template <class A>
typename A::Number near_value(const A& a, const Plane& x, const Point3& p) {
  return dot(difference(a, p, x.eye), difference(a, x.target, x.eye)) - near_offset(a, x);
}

/// x(p), as plane.h defines it.
template <class A>
typename A::Number value(const A& a, const Plane& x, const Point3& p) {
  if (x.kind == Plane::Kind::span) return span_value(a, x, p);
  if (x.kind == Plane::Kind::near) return near_value(a, x, p);
  return near_value(a, x, p) * span_value(a, x, x.eye) + near_offset(a, x) * span_value(a, x, p);
}

/// x(p) y(q) - x(q) y(p)
template <class A>
typename A::Number cross_value(const A& a, const Plane& x, const Plane& y, const Point3& p, const Point3& q) {
  return value(a, x, p) * value(a, y, q) - value(a, x, q) * value(a, y, p);
}

/// det(n_a, n_b, n_c)
template <class A>
typename A::Number meet_value(const A& a, const Plane& p, const Plane& q, const Plane& r) {
  return dot(normal(a, p), cross(normal(a, q), normal(a, r)));
}

/// x at the common point of p, q and r, times meet_value(p, q, r): with every plane as n . (X - o_x) = d, Cramer's rule gives
/// X - o_x = (d_p n_q x n_r + d_q n_r x n_p + d_r n_p x n_q) / det(n_p, n_q, n_r).
template <class A>
typename A::Number meet_side_value(const A& a, const Plane& x, const Plane& p, const Plane& q, const Plane& r) {
  const auto nx = normal(a, x), np = normal(a, p), nq = normal(a, q), nr = normal(a, r);
  const auto dp = dot(np, difference(a, p.o, x.o)), dq = dot(nq, difference(a, q.o, x.o)),
             dr = dot(nr, difference(a, r.o, x.o));
  return dp * dot(nx, cross(nq, nr)) + dq * dot(nx, cross(nr, np)) + dr * dot(nx, cross(np, nq));
}

}  // namespace hsr::polynomials
