#pragma once

#include <cmath>
#include <optional>

#include "hsr/sight.h"

namespace hsr {

/// Twice the area of the triangle of three images, positive where they turn left: O of what they are images of has its sign.
/// @param error of each coordinate @see ImageLine for the bound
inline ErrorBounded image_turn(const ImagePoint& p, const ImagePoint& q, const ImagePoint& r, double error) {
  const double dx = q.x - p.x, dy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
  const double d = std::fabs(dx) + std::fabs(dy), l = std::fabs(rx) + std::fabs(ry);
  return {dx * ry - dy * rx, 2.2 * error * (d + l) + 9.1 * error * error + 4.2 * ErrorBounded::u * d * l + 0x1p-1000};
}

/// The line through the images of two vertices a and b, prepared for many points: the sign of O(a, b, p).
///
/// With E = image_error(), r = p - a and d = b - a as computed: every entry of r and d is off by at most 2 E and one rounding u
/// of its own; the two products and their difference round three times. So |det - exact| <= 2.1 E (|d|_1 + |r|_1) + 9 E^2 +
/// 4.1 u (|d_x r_y| + |d_y r_x|) + 2^-1073, and the last sum is at most |d|_1 |r|_1. The bound is computed with constants a
/// little larger, which pays for its own roundings. An image that is not known is NaN and never certain.
class ImageLine {
 public:
  ImageLine(const Sight& sight, VertexId a, VertexId b) : sight_(sight), a_(a), b_(b) {
    if (!(sight.image_error() < HUGE_VAL)) return;
    const ImagePoint &p = sight.image(a), &q = sight.image(b);
    ax_ = p.x;
    ay_ = p.y;
    dx_ = q.x - p.x;
    dy_ = q.y - p.y;
    const double error = sight.image_error(), length = std::fabs(dx_) + std::fabs(dy_);
    least_ = 2.2 * error * length + 9.1 * error * error + 0x1p-1000;
    slope_ = 2.2 * error + 4.2 * ErrorBounded::u * length;
  }

  /// Zero: doubles cannot tell.
  Sign certain_side(VertexId p) const {
    if (!(least_ < HUGE_VAL)) return Sign::zero;
    const ImagePoint& c = sight_.image(p);
    const double rx = c.x - ax_, ry = c.y - ay_;
    const double det = dx_ * ry - dy_ * rx, bound = least_ + slope_ * (std::fabs(rx) + std::fabs(ry));
    return det > bound ? Sign::positive : det < -bound ? Sign::negative : Sign::zero;
  }

  /// The sign of O(a, b, p) where doubles tell it, a zero too: exact images on a line along an axis need only comparisons, and
  /// elevations are full of them.
  std::optional<Sign> side_by_doubles(VertexId p) const {
    const Sign certain = certain_side(p);
    if (certain != Sign::zero) return certain;
    if (sight_.image_error() != 0 || (dx_ != 0 && dy_ != 0)) return std::nullopt;
    const ImagePoint& c = sight_.image(p);
    return dx_ == 0 ? -sign_of(dy_) * sign_of(c.x - ax_) : sign_of(dx_) * sign_of(c.y - ay_);
  }

  /// The sign of O(a, b, p). Exact.
  Sign side(VertexId p, Predicates& exact) const {
    const std::optional<Sign> s = side_by_doubles(p);
    if (!s) return exact.side_beyond_filter(sight_.sight_plane(a_, b_), sight_.point(p));
    ++exact.counts().filter;
    if (*s == Sign::zero) ++exact.counts().zero;
    return *s;
  }

  /// Whether a and b are seen as one point, so that there is no line. Exact.
  bool is_point(Predicates& exact) const {
    if (least_ < HUGE_VAL && std::fabs(dx_) + std::fabs(dy_) > 9 * sight_.image_error() + 0x1p-900) return false;
    // Iff every plane of the line of sight of a contains b.
    for (int axis = 0; axis < 3; ++axis)
      if (exact.side(Plane::of_sight_along_axis(sight_.eye(), sight_.point(a_), axis), sight_.point(b_)) != Sign::zero)
        return false;
    return true;
  }

  /// For points on the line: whether p certainly lies before a, as seen on the way from a to b; after a; after b; before b.
  bool certainly_before_start(VertexId p) const { return along(p, ax_, ay_) == Sign::negative; }
  bool certainly_after_start(VertexId p) const { return along(p, ax_, ay_) == Sign::positive; }
  bool certainly_before_end(VertexId p) const { return along(p, ax_ + dx_, ay_ + dy_) == Sign::negative; }
  bool certainly_after_end(VertexId p) const { return along(p, ax_ + dx_, ay_ + dy_) == Sign::positive; }

 private:
  /// The sign of (p - o) . (b - a) in the image, or zero where doubles cannot tell: the same bound as for O, with o = b off by
  /// one rounding more.
  Sign along(VertexId p, double ox, double oy) const {
    if (!(least_ < HUGE_VAL)) return Sign::zero;
    const ImagePoint& c = sight_.image(p);
    const double rx = c.x - ox, ry = c.y - oy, dot = dx_ * rx + dy_ * ry;
    const double bound = 2 * (least_ + slope_ * (std::fabs(rx) + std::fabs(ry) + std::fabs(ox) + std::fabs(oy)));
    return dot > bound ? Sign::positive : dot < -bound ? Sign::negative : Sign::zero;
  }

  const Sight& sight_;
  VertexId a_, b_;
  double ax_ = 0, ay_ = 0, dx_ = 0, dy_ = 0;
  double least_ = HUGE_VAL, slope_ = 0;
};

}  // namespace hsr
