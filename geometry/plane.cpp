#include "geometry/plane.h"

#include "geometry/error.h"

namespace hsr {

namespace {

constexpr Point3 unit(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

Plane span(const Point3& o, const Point3& u, Plane::Support u_is, const Point3& v, Plane::Support v_is) {
  Plane plane;
  plane.u_is = u_is;
  plane.v_is = v_is;
  plane.o = o;
  plane.u = u;
  plane.v = v;
  return plane;
}

}  // namespace

Plane Plane::of_face(const Point3& a, const Point3& b, const Point3& c) {
  return span(a, b, Support::point, c, Support::point);
}

Plane Plane::of_sight(const Viewpoint& e, const Point3& c, const Point3& d) {
  return e.is_direction ? span(c, e.at, Support::direction, d, Support::point)
                        : span(e.at, d, Support::point, c, Support::point);
}

Plane Plane::along_axis(const Point3& c, const Point3& d, int axis) {
  return span(c, d, Support::point, unit(axis), Support::axis);
}

Plane Plane::across(const Point3& c, int axis) {
  return span(c, unit((axis + 1) % 3), Support::axis, unit((axis + 2) % 3), Support::axis);
}

Plane Plane::of_sight_along_axis(const Viewpoint& e, const Point3& c, int axis) {
  return e.is_direction ? span(c, unit(axis), Support::axis, e.at, Support::direction) : along_axis(e.at, c, axis);
}

Plane Plane::near(const Point3& eye, const Point3& target, double k) {
  Plane plane;
  plane.kind = Kind::near;
  plane.eye = eye;
  plane.target = target;
  plane.k = k;
  return plane;
}

Plane Plane::near_line(const Point3& eye, const Point3& target, double k, const Plane& line) {
  return near(eye, target, k).line_with(line);
}

Plane Plane::section(const Viewpoint& eye, const Point3& point, const Point3& normal) {
  Plane plane;
  plane.kind = Kind::near;
  plane.eye = eye.at;
  plane.eye_is_direction = eye.is_direction;
  plane.is_section = true;
  plane.target = point;
  plane.normal = normal;
  return plane;
}

Plane Plane::line_with(const Plane& line) const {
  require(line.kind == Kind::span || line.is_section, "Plane::near_line: the line's plane must be spanned by points");
  Plane plane = *this;
  plane.kind = Kind::near_line;
  if (line.kind != Kind::span) {
    plane.u_is = Support::normal;
    plane.o = line.target;
    plane.u = line.normal;
    return plane;
  }
  plane.u_is = line.u_is;
  plane.v_is = line.v_is;
  plane.o = line.o;
  plane.u = line.u;
  plane.v = line.v;
  return plane;
}

}  // namespace hsr
