#pragma once

#include "hsr/image.h"
#include "hsr/raster/depth_format.h"
#include "hsr/scene/tie_rule.h"

namespace hsr::internal {

/// When a sample of a triangle takes the place of what the buffer has. `less` is nearer, in a reversed buffer too.
enum class DepthFunction : std::uint8_t { never, less, equal, lequal, greater, notequal, gequal, always };

/// How a triangle's depth gets to its samples.
enum class DepthInterpolation : std::uint8_t {
  plane,        ///< by its plane, z + (i - x) dz/dx + (j - y) dz/dy, at the first sample of a row; then dz/dx is added
  incremental,  ///< the textbook: the side moves by 1/m a row, and z by what that and the row change; then z - A/C a sample
  barycentric,  ///< the corners' depths, weighted with the three areas at each sample
};

struct DepthBufferOptions {
  DepthFormat format = DepthFormat::fixed24;
  DepthFunction function = DepthFunction::less;
  DepthInterpolation interpolation = DepthInterpolation::plane;
  /// Added to each depth: steps of the format (of floats: at depth 1), and multiples of the triangle's largest slope. Above 0:
  /// farther away.
  double bias = 0, slope_bias = 0;
  TieRule ties = {};  ///< what is on top is drawn first
};

/// A picture by a depth buffer, and the depths that it has at the end.
struct DepthBuffer {
  Image<TriangleId> triangles;     ///< not valid: the background
  Image<double> depths;            ///< 0 near ... 1 far, decoded
  std::size_t bytes_a_sample = 0;  ///< what the format takes for the depth
};

/// The z-buffer as graphics systems have it: depths from 0 to 1 between a near and a far plane, in a format of few bits.
///
///   (1) all begins at depth 1; for `greater` and `gequal`, which look for what is farthest, at 0
///   (2) samples nearer than the near plane or beyond the far plane are not drawn
///   (3) with `less`, of equal depths the one on top is shown; with `lequal` the lowest
///   (4) samples on edges as z_buffer() has them
///
/// Fixed formats interpolate in doubles and round to the nearest step; the floats of 32 bits do all with floats.
/// @throws InputError for a logarithmic format in a parallel view
/// Exact: no. Cost: O(n + samples drawn); one thread.
/// Source: Catmull 1974; depth bias as glPolygonOffset has it.
DepthBuffer depth_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                         const DepthBufferOptions& options = {});

}  // namespace hsr::internal
