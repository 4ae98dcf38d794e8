#pragma once

#include <string>
#include <vector>

#include "hsr/raster/depth_format.h"

namespace hsr::internal {

/// How near two walls that face the eye may be, one behind the other, in a depth buffer.
struct MeasuredGap {
  std::string drawn_by = "hsr";  ///< or the driver: "OpenGL, llvmpipe"
  DepthFormat format = DepthFormat::fixed24;
  double distance = 0, near = 0, far = 0;
  double predicted = 0;  ///< one step of the format: smallest_gap()
  /// The smallest of the distance over powers of two at which the nearer wall is shown at all samples, and so at all larger
  /// ones.
  double measured = 0;
};

/// All formats at one distance, with the near plane at three places: what more bits, a larger n / f and a reversed buffer buy; then
/// those of the driver, where there is one.
/// Cost: some ten milliseconds.
std::vector<MeasuredGap> measured_gaps();

/// A decal in the plane of a sloping wall that is drawn with a bias, away from the eye.
struct MeasuredBias {
  std::string drawn_by = "hsr";  ///< or the driver, whose polygon offset moves the decal toward the eye instead
  DepthFormat format = DepthFormat::fixed24;
  double bias = 0, slope_bias = 0;  ///< DepthBufferOptions
  double shown_share = 0;           ///< of the decal's samples
  /// What it costs: up to this gap behind the wall something is shown that the wall hides, at some sample. A power of two times
  /// the distance; 0: none that was tried.
  double shines_through = 0;
};

std::vector<MeasuredBias> measured_biases();

}  // namespace hsr::internal
