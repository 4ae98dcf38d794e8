#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "geometry/mesh.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// How a depth buffer holds depths. All but `reversed_float32` have 0 at the near plane and 1 at the far one.
enum class DepthFormat : std::uint8_t {
  fixed8,
  fixed16,
  fixed24,
  fixed32,  ///< whole multiples of 1 / (2^bits - 1)
  float32,
  float64,
  reversed_float32,    ///< 1 - depth: the dense numbers near 0 are at the far plane, where perspective needs them
  logarithmic_float32  ///< log(z / near) / log(far / near): the same relative resolution everywhere. Perspective only.
};

constexpr std::array<DepthFormat, 8> depth_formats = {
    DepthFormat::fixed8,  DepthFormat::fixed16, DepthFormat::fixed24,          DepthFormat::fixed32,
    DepthFormat::float32, DepthFormat::float64, DepthFormat::reversed_float32, DepthFormat::logarithmic_float32};

/// "fixed 24", "float 32 reversed", ...
std::string_view name(DepthFormat format);
/// 0: floating point
int fixed_bits(DepthFormat format);

/// The near and far planes of a depth buffer. `near` and `far` are nearnesses (Seen::nearness, sample_projection.h), near > far.
///
/// The depth of a point is d = (near - nearness) / (near - far), which in perspective is the classical
/// f (z - n) / (z (f - n)): linear over the picture, and so it can be interpolated, but most of its range lies close to the
/// near plane. In parallel views it is linear in the distance.
struct DepthRange {
  double near = 1, far = 0;
  bool is_perspective = false;

  double depth(double nearness) const { return (near - nearness) / (near - far); }
  /// Perspective: distance over that of the plane of the samples. @pre a perspective range
  double near_distance() const { return 1 / (near + 1); }
};

/// The range that holds all of the mesh beyond the view's near plane, and a 1024th more on each side. Nothing there: any range.
DepthRange depth_range(const Mesh& mesh, const View& view, const SampleGrid& samples);
/// Perspective: distances from the eye along the line of sight to the target, in model units.
/// @throws InputError unless 0 < near < far, finite, and the view is a perspective
DepthRange depth_range(const View& view, const SampleGrid& samples, double near, double far);

/// One step of the format at a nearness, as a nearness.
double step(DepthFormat format, const DepthRange& range, double nearness);

/// The lecture's form of the same: with z = -1 at the far plane and z = c = -n / f at the near one, as the view volume is
/// normalised, z' = (c - z) / (z + z c), from 0 at the near plane to -1 at the far one.
double transformed_depth(double z, double near, double far);

/// The gap, in the unit of z, between two surfaces at distance z whose depths are one step of the format apart, with near and
/// far plane at n and f: the step over the derivative of the depth (of a logarithmic buffer, its own). So
/// z^2 (f - n) / (n f 2^b), about z^2 / (n 2^b), of b fixed bits. Both depths are rounded: to be told apart for sure, surfaces
/// need a few of these.
/// Source: Akeley & Su 2006; Reed 2015 (reversed); Kemen 2009 (logarithmic).
double smallest_gap(DepthFormat format, double z, double near, double far);

}  // namespace hsr::internal
