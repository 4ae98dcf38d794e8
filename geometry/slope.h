#pragma once

#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"
#include "geometry/view_plane.h"

namespace hsr::internal {

/// The sign of x(q) - x(p): how a plane's value changes on the way from p to q.
///
/// Zero: the plane is parallel to pq (or contains it). Exact: yes, for every finite input; intervals, then big floats. Cost: a
/// microsecond; for the few signs that no bound in doubles decides.
Sign slope(const Plane& x, const Point3& p, const Point3& q);

/// The sign of x(q) - x(p) for the view plane of a line in the image.
Sign slope(const Camera& camera, const ViewPlane& x, const Point3& p, const Point3& q);

}  // namespace hsr::internal
