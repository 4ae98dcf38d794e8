#pragma once

#include <array>
#include <cstdint>

#include "geometry/simd.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// A triangle in floats, a coordinate of all three corners at a time: in the image and the nearness of its boxes, of which
/// perspectives take the reciprocal, so that planes are planes. A cache line.
struct alignas(64) FloatTriangle {
  std::array<float, 4> x, y, z;         ///< then: by how much each coordinate may be off; the sum of the extents; nothing
  std::array<std::uint32_t, 4> vertex;  ///< then: `other`, or `single` if the triangle is a facet of its own

  static constexpr std::uint32_t other = 0xffffffffU, single = 0xfffffffeU;  // no vertices

  FloatTriangle() = default;
  /// @param is_single it is a facet of its own
  FloatTriangle(const ProjectedMesh& projected, TriangleId t, bool is_single);

  float error() const { return x[3]; }
  float size() const { return y[3]; }
  bool is_single() const { return vertex[3] == single; }
};

/// A triangle prepared to be told apart from many others.
class TriangleSeparation {
 public:
  explicit TriangleSeparation(const FloatTriangle& s);

  /// Whether the two certainly have nothing in common but corners and a side that they share: the one is seen beyond a side of
  /// the other, or it lies on one side of the other's plane. Common corners count as on that side or plane; a common side only
  /// of two facets that are one triangle each.
  /// @pre the boxes of the two touch
  bool is_apart_from(const FloatTriangle& t) const;

 private:
  bool has_beyond_side(const FloatTriangle& t) const;
  bool has_beside_plane(const FloatTriangle& t) const;

  const FloatTriangle& s_;
  float turn_ = 0;  // 1: the corners run counter-clockwise in the floats' image, certainly; -1: clockwise; 0: not known
  std::array<float, 4> dx_, dy_;  // of the sides, from each corner to the next
};

}  // namespace hsr::internal
