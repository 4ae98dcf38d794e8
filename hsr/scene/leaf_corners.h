#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "geometry/plane_filter.h"
#include "geometry/simd.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// A plane prepared for all triangles of many leaves, in floats that are scaled by its normal.
struct LeafPlane {
  PlaneFilter filter;
  std::array<float, 3> normal = {};  ///< the greatest entry is 1
  double scale = 0;                  ///< of the filter's normal to this one; 0: nothing is told
  double per_reach = 0;              ///< by how much a value may be off for each unit of the way from a leaf's middle

  LeafPlane() = default;
  explicit LeafPlane(const PlaneFilter& plane);
};

/// The corners of the triangles of a leaf of a tree, a coordinate at a time, to look at all of them at once.
///
/// Value: n . d, d the way from the middle of the leaf, where the plane's value is known in doubles. With n scaled so that its
/// greatest entry is 1, r = |d_x| + |d_y| + |d_z|, v = 2^-24: n and d round by v each, products by v, sums by 2 v, so the floats are
/// off by at most 5.1 v r, and n itself by its filter's slope, scaled: per_reach = 8 v + slope. Underflow adds less than 2^-120.
class LeafCorners {
 public:
  static constexpr std::size_t width = 8;

  LeafCorners() = default;
  /// @param triangles at most eight
  LeafCorners(const ProjectedMesh& projected, std::span<const TriangleId> triangles);

  /// Bit k: all corners of triangle k are certainly on one side of the plane.
  unsigned beside(const LeafPlane& plane) const;

 private:
  alignas(32) std::array<std::array<std::array<float, width>, 3>, 3> ways_ = {};  // by corner and coordinate
  Point3 middle_ = {};
  double reach_ = HUGE_VAL;
};

inline LeafPlane::LeafPlane(const PlaneFilter& plane) : filter(plane) {
  const double most = norm_max({plane.nx, plane.ny, plane.nz});
  if (!(most > 0x1p-400 && most < 0x1p400)) return;
  scale = 1 / most;
  normal = {static_cast<float>(plane.nx * scale), static_cast<float>(plane.ny * scale), static_cast<float>(plane.nz * scale)};
  per_reach = (8 * 0x1p-24 + plane.slope * scale) * 1.01;
}

inline unsigned LeafCorners::beside(const LeafPlane& plane) const {
  if (plane.scale == 0) return 0;
  const ErrorBounded at = plane.filter(middle_);
  const double value = at.value * plane.scale;
  const double error = (at.error * plane.scale + std::fabs(value) * 0x1p-50 + plane.per_reach * reach_ + 0x1p-100) * 1.01;
  // Rounded to floats, away from what they bound.
  const auto outward = [](double x, double sign) { return static_cast<float>(x + sign * (std::fabs(x) * 0x1p-22 + 0x1p-120)); };
  const FourFloats above = FourFloats::all(outward(error - value, 1)), below = FourFloats::all(outward(-error - value, -1));
  const FourFloats nx = FourFloats::all(plane.normal[0]), ny = FourFloats::all(plane.normal[1]),
                   nz = FourFloats::all(plane.normal[2]);
  unsigned bits = 0;
  for (std::size_t k = 0; k < width; k += 4) {
    const auto dot = [&](std::size_t corner) {
      const auto& way = ways_[corner];
      return nx * FourFloats::load(&way[0][k]) + ny * FourFloats::load(&way[1][k]) + nz * FourFloats::load(&way[2][k]);
    };
    const FourFloats a = dot(0), b = dot(1), c = dot(2);
    const FourFloats is_beside = ((a > above) & (b > above) & (c > above)) | ((a < below) & (b < below) & (c < below));
    bits |= is_beside.bits() << k;
  }
  return bits;
}

}  // namespace hsr::internal
