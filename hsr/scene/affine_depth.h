#pragma once

#include <cmath>
#include <limits>

#include "hsr/scene/projected_mesh.h"

namespace hsr {

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

}  // namespace hsr
