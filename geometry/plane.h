#pragma once

#include "geometry/point.h"

namespace hsr {

/// A plane, kept as the input points that span it: never as coefficients that were computed, so nothing is ever rounded.
///
/// `value(p)`, the polynomial whose sign `side` gives, is
///   span       det(u - o, v - o, p - o), where a `u` or `v` that is a direction stands for itself; degree 3 in the input
///   near       (p - eye) . (target - eye) - k |target - eye|^2; positive beyond the near plane. Of a section, which takes its
///              place: normal . (p - target), where target is a point of the section
///   near_line  near(p) L(eye) - near(eye) L(p): the plane of the eye and of the line where the near plane meets the span L; for
///              a direction D toward the viewer near(eye) and L(eye) are the gradients times D. L may be a second section
///
/// Degenerate: points that span no plane make `value` zero everywhere.
struct Plane {
  enum class Kind : unsigned char { span, near, near_line };
  enum class Support : unsigned char {
    point,
    direction,
    axis,
    normal,  ///< `u` is square to the plane: of a section that a near_line is made of
  };

  Kind kind = Kind::span;
  Support u_is = Support::point, v_is = Support::point;
  Point3 o, u, v;
  Point3 eye, target;  ///< near, near_line only
  double k = 0;        ///< near, near_line only
  Point3 normal;       ///< of a section
  bool is_section = false, eye_is_direction = false;

  /// The plane of a face. Positive where orientation(a, b, c, p) is.
  static Plane of_face(const Point3& a, const Point3& b, const Point3& c);

  /// The view plane of the viewpoint and of c and d. Its value O(c, d, p) is positive where p is to the left of c -> d as seen
  /// from the viewpoint: where c, d, p turn counter-clockwise, and the viewpoint is on the positive side of their plane. With
  /// an eye det(d - e, c - e, p - e), with a direction D toward the viewer its limit det(D, d - c, p - c).
  static Plane of_sight(const Viewpoint& e, const Point3& c, const Point3& d);

  /// The plane through c and d parallel to a coordinate axis: the line cd in the coordinates other than `axis`.
  static Plane along_axis(const Point3& c, const Point3& d, int axis);

  /// The plane through c square to a coordinate axis; positive beyond it along the axis.
  static Plane across(const Point3& c, int axis);

  /// The plane through the viewpoint and c parallel to a coordinate axis, signed like `along_axis(e, c, axis)`.
  static Plane of_sight_along_axis(const Viewpoint& e, const Point3& c, int axis);

  static Plane near(const Point3& eye, const Point3& target, double k);
  /// @throws PreconditionError unless `line` is a span
  static Plane near_line(const Point3& eye, const Point3& target, double k, const Plane& line);
  /// The plane through `point` that is square to `normal`, in place of the near plane. @pre its value at the viewpoint is negative
  static Plane section(const Viewpoint& eye, const Point3& point, const Point3& normal);
  /// The near_line of `line` for this near plane or section. @throws PreconditionError unless `line` is a span or a section
  Plane line_with(const Plane& line) const;
};

}  // namespace hsr
