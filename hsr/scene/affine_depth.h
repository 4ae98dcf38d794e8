#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The nearness of a triangle's plane as a function of the image point (x, y): value + dx (x - p.x) + dy (y - p.y). Over the
/// triangle it errs by at most `error`.
///
/// Two affine functions differ over a triangle by at most what they differ by at its corners. So the gradient may be rounded in
/// any way: `error` bounds what comes out at the corners, and the rounding of an evaluation in between.
struct AffineDepth {
  ImagePoint p = {0, 0};
  double value = 0, dx = 0, dy = 0, error = HUGE_VAL;
  double farthest = -HUGE_VAL, nearest = HUGE_VAL;  // of the corners

  /// An upper bound of the exact nearness where the function above has a value of at most `high`.
  double at_most(double high) const { return high + error < nearest ? high + error : nearest; }
};

/// What is known of a triangle's corners: where each is seen, within `image_error` in each coordinate, and between which values
/// its nearness lies.
struct DepthCorners {
  std::array<ImagePoint, 3> image;
  double image_error = 0;
  std::array<double, 3> low, high;
};

/// The AffineDepth of a triangle whose corners are known so. At a corner it is off by what it is off by at the corner's image
/// as given, from the middle of low and high; by half of their distance; and by dx and dy times the error of the image. The
/// roundings of at(p) are at most 16 u (|dx| reach_x + |dy| reach_y + |value|) where every |x| and |y| that take part, and
/// |x - p.x| and |y - p.y|, are below the reach. Constants are larger by a half or more, which pays for the roundings of the
/// bound itself. Where a corner or the bound is not finite, the error is infinite.
AffineDepth affine_depth(const DepthCorners& corners, double reach_x, double reach_y);

/// The nearness that a tile keeps while nothing covers it: no point is less near, so nothing is hidden there. Searches for a
/// least nearness start from the opposite, +infinity.
constexpr float no_occluder = -std::numeric_limits<float>::infinity();
constexpr float largest_float = std::numeric_limits<float>::max();

/// Rounding down and up to a float: float_below(x) <= x <= float_above(x). Beyond the range of floats, and for NaN, the answer
/// is the infinity that claims nothing, or the largest float where that is a bound.
inline float float_below(double x) {
  const double lower = x - std::fabs(x) * 0x1p-22 - 0x1p-120;
  if (!(lower >= -largest_float)) return no_occluder;
  return lower > largest_float ? largest_float : static_cast<float>(lower);
}
inline float float_above(double x) { return -float_below(-x); }

}  // namespace hsr::internal
