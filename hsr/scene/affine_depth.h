#pragma once

#include <cmath>
#include <limits>

#include "hsr/scene/projected_mesh.h"

namespace hsr {

/// The nearness of a triangle's plane as a function of the image, at(p) = value + dx (x - p.x) + dy (y - p.y), which over the
/// triangle is off by at most `error`.
///
/// Two affine functions differ over a triangle by at most what they differ by at its corners. So the gradient may be any: only
/// what comes out at the corners counts, and the roundings of where it is taken.
struct AffineDepth {
  ImagePoint p = {0, 0};
  double value = 0, dx = 0, dy = 0, error = HUGE_VAL;
  double farthest = -HUGE_VAL, nearest = HUGE_VAL;  // of the corners

  /// Bounds it over what the triangle has below this value, where it is affine.
  double at_most(double high) const { return high + error < nearest ? high + error : nearest; }
};

/// The nearness of nothing: nothing is less near.
constexpr float no_occluder = -std::numeric_limits<float>::infinity();
constexpr float largest_float = std::numeric_limits<float>::max();

/// A float that is not above x, and one that is not below it; where x is not finite, one that says nothing.
inline float float_below(double x) {
  const double lower = x - std::fabs(x) * 0x1p-22 - 0x1p-120;
  if (!(lower >= -largest_float)) return no_occluder;
  return lower > largest_float ? largest_float : static_cast<float>(lower);
}
inline float float_above(double x) { return -float_below(-x); }

}  // namespace hsr
