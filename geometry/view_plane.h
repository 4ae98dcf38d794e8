#pragma once

#include <array>

#include "geometry/error_bounded.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"

namespace hsr {

/// What decides where the image of a point lies: the viewpoint and, with an eye, the direction in which it looks.
struct Camera {
  Viewpoint eye;
  Point3 target;  ///< perspective only: an image point is a ray from the eye with a positive share of target - eye
};

/// A plane through the viewpoint, which is seen as a line: a plane that contains the viewpoint by construction, or the plane of
/// the viewpoint and the line where two other planes meet.
///
/// Its value at p is x(p), or x(E) y(p) - y(E) x(p), where x(E) is x at the eye; for a direction D the limit n . D. The line
/// runs so that the positive side is on its left, as seen.
///
/// For a meet this tells which of two planes is nearer: x is nearer than y on the line of sight of p iff the sign of the value
/// at p is x(E) y(E). So where both are positive at the eye, the value is positive where x is nearer.
/// @pre neither x nor y of a meet contains the viewpoint
struct ViewPlane {
  Plane x, y;
  bool is_meet = false;

  static ViewPlane of(const Plane& through_viewpoint) { return {through_viewpoint, {}, false}; }
  static ViewPlane of_meet(const Plane& x, const Plane& y) { return {x, y, true}; }
};

/// Image coordinates of where the lines of two view planes cross, in doubles with a proven bound; an error that is not finite
/// where they tell nothing.
///
/// Parallel: with k the axis of the largest entry of the direction, i and j the next two: the coordinates i and j of the point
/// in the plane of the axes i and j through `origin`, relative to it. Perspective: (u . q, v . q) / (target - eye) . q for the
/// direction q of the point, where u and v are `rows`.
std::array<ErrorBounded, 2> image_of_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m,
                                              const Point3& origin, const std::array<Point3, 2>& rows);
/// Image coordinates of a point, in doubles with a proven bound; as for image_of_crossing().
std::array<ErrorBounded, 2> image_of_point(const Camera& camera, const Point3& p, const Point3& origin,
                                           const std::array<Point3, 2>& rows);

/// The point of the plane x that is seen where the lines of l and m cross; on the line of sight of p. Exact.
/// @throws PreconditionError if the lines are parallel in the image, or x contains the viewpoint or is parallel to the line of sight
std::array<Rational, 3> exact_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x);
std::array<Rational, 3> exact_point(const Camera& camera, const Point3& p, const Plane& x);
/// The point of the plane x that is seen where the lines of l and m cross, in doubles with proven bounds; errors that are not
/// finite where they tell nothing.
std::array<ErrorBounded, 3> bounded_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x);
/// The coordinates of image_of_crossing and image_of_point. Exact.
/// @throws PreconditionError if the lines are parallel in the image
std::array<Rational, 2> exact_image_of_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m,
                                                const Point3& origin, const std::array<Point3, 2>& rows);
std::array<Rational, 2> exact_image_of_point(const Camera& camera, const Point3& p, const Point3& origin,
                                             const std::array<Point3, 2>& rows);

/// The axis of the largest entry of a direction, the lowest of equal ones.
int largest_axis(const Point3& direction);

}  // namespace hsr
