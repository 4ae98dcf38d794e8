#pragma once

#include <cmath>

#include "geometry/error_bounded.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The segment between two points of the image, prepared for many others.
///
/// With E the error of each coordinate of all these points, r = point - p and d = q - p as computed: every entry of r and d is
/// off by at most 2 E and one rounding u of its own; the two products and their difference round three times. So
/// |det - exact| <= 2.1 E (|d|_1 + |r|_1) + 9 E^2 + 4.1 u (|d_x r_y| + |d_y r_x|) + 2^-1073, and the last sum is at most
/// |d|_1 |r|_1. The bound is computed with constants a little larger, which pays for its own roundings. What is not known is
/// not a number, or has an unbounded error, and is never certain.
struct SegmentFilter {
  ImagePoint p = {0, 0}, q = {0, 0};
  double error = HUGE_VAL;
  double dx = 0, dy = 0;
  double least = HUGE_VAL, slope = 0;  ///< the error of the determinant is at most least + slope |r|_1

  SegmentFilter() = default;
  SegmentFilter(const ImagePoint& from, const ImagePoint& to, double e)
      : p(from), q(to), error(e), dx(q.x - p.x), dy(q.y - p.y) {
    const double length = std::fabs(dx) + std::fabs(dy);
    least = 2.2 * e * length + 9.1 * e * e + 0x1p-1000;
    slope = 2.2 * e + 4.2 * ErrorBounded::u * length;
  }

  /// The determinant of d and r, positive where p, q and the point turn left: O of what they are images of has its sign.
  ErrorBounded turn(const ImagePoint& point) const {
    const double rx = point.x - p.x, ry = point.y - p.y;
    return {dx * ry - dy * rx, least + slope * (std::fabs(rx) + std::fabs(ry))};
  }
  /// The scalar product of d and point - o, positive where the point lies beyond o as the segment runs. Its two products and
  /// their sum err as those of the determinant; the bound is twice that one. @param o p or q
  ErrorBounded along(const ImagePoint& point, const ImagePoint& o) const {
    const double rx = point.x - o.x, ry = point.y - o.y;
    return {dx * rx + dy * ry, 2 * (least + slope * (std::fabs(rx) + std::fabs(ry)))};
  }
};

}  // namespace hsr::internal
