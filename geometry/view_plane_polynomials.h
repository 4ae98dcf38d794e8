#pragma once

#include "geometry/polynomials.h"
#include "geometry/view_plane.h"

// The polynomials of lines in the image, in homogeneous coordinates: see polynomials.h.

namespace hsr::internal::polynomials {

template <class N>
struct PlaneAtEye {
  Vector<N> normal;
  N at_eye;
};

/// The normal of a plane, and its value at the viewpoint: x(e), or n . D.
template <class A>
auto plane_at_eye(const A& a, const Camera& camera, const Plane& x) {
  using N = typename A::Number;
  if (x.kind == Plane::Kind::near) return PlaneAtEye<N>{near_normal(a, x), near_at_eye(a, x)};
  const auto n = normal(a, x);
  const Point3& e = camera.eye.at;
  if (!camera.eye.is_direction) return PlaneAtEye<N>{n, dot(n, difference(a, e, x.o))};
  return PlaneAtEye<N>{n, dot(n, Vector<N>{a.direction(e, 0), a.direction(e, 1), a.direction(e, 2)})};
}

/// The value of a view plane at p.
template <class A>
typename A::Number view_value(const A& a, const Camera& camera, const ViewPlane& l, const Point3& p) {
  if (!l.is_meet) return value(a, l.x, p);
  const auto x = plane_at_eye(a, camera, l.x), y = plane_at_eye(a, camera, l.y);
  return x.at_eye * value(a, l.y, p) - y.at_eye * value(a, l.x, p);
}

/// The line as a vector l: an image point with the homogeneous coordinates q lies on the side sign(l . q).
///
/// Perspective: l is the plane's normal and q the ray from the eye. Parallel, with k the axis of the direction's largest entry
/// and i, j the next two: n . D = 0, so n . (p - o) + c = (n_i q_0 + n_j q_1 + c q_2) / D_k for q = (D_k (p - o)_i - D_i (p -
/// o)_k, D_k (p - o)_j - D_j (p - o)_k, D_k); l = (n_i, n_j, c), c the value at `origin` o.
template <class A>
auto line(const A& a, const Camera& camera, const ViewPlane& l, const Point3& origin) {
  using V = Vector<typename A::Number>;
  const bool is_parallel = camera.eye.is_direction;
  if (!l.is_meet && l.x.kind == Plane::Kind::span) {
    auto n = normal(a, l.x);
    if (!is_parallel) return n;
    const auto c = l.x.o == origin ? typename A::Number(n.x - n.x) : dot(n, difference(a, origin, l.x.o));
    const int k = largest_axis(camera.eye.at);
    return k == 0 ? V{n.y, n.z, c} : k == 1 ? V{n.z, n.x, c} : V{n.x, n.y, c};
  }
  if (!l.is_meet && l.x.kind == Plane::Kind::near) {  // a section that is seen edge-on
    const auto n = near_normal(a, l.x);
    if (!is_parallel) return n;
    const auto c = near_value(a, l.x, origin);
    const int k = largest_axis(camera.eye.at);
    return k == 0 ? V{n.y, n.z, c} : k == 1 ? V{n.z, n.x, c} : V{n.x, n.y, c};
  }
  Plane first = l.x, second = l.y;
  if (!l.is_meet) {  // a near_line is the meet of its span and the near plane
    first.kind = Plane::Kind::span;
    second = l.x;
    second.kind = Plane::Kind::near;
  }
  const auto x = plane_at_eye(a, camera, first), y = plane_at_eye(a, camera, second);
  V n = {x.at_eye * y.normal.x - y.at_eye * x.normal.x, x.at_eye * y.normal.y - y.at_eye * x.normal.y,
         x.at_eye * y.normal.z - y.at_eye * x.normal.z};
  if (!is_parallel) return n;
  const auto c = x.at_eye * value(a, second, origin) - y.at_eye * value(a, first, origin);
  const int k = largest_axis(camera.eye.at);
  return k == 0 ? V{n.y, n.z, c} : k == 1 ? V{n.z, n.x, c} : V{n.x, n.y, c};
}

/// The third coordinate of l x m, whose sign tells on which side of the eye the rays of their crossing point.
template <class A>
typename A::Number crossing_weight(const A& a, const Camera& camera, const ViewPlane& l, const ViewPlane& m) {
  const auto q = cross(line(a, camera, l, l.x.o), line(a, camera, m, l.x.o));
  return camera.eye.is_direction ? q.z : dot(difference(a, camera.target, camera.eye.at), q);
}

/// det(l, m, n)
template <class A>
typename A::Number lines_value(const A& a, const Camera& camera, const ViewPlane& l, const ViewPlane& m, const ViewPlane& n) {
  const Point3& o = l.x.o;
  return dot(line(a, camera, n, o), cross(line(a, camera, l, o), line(a, camera, m, o)));
}

}  // namespace hsr::internal::polynomials
