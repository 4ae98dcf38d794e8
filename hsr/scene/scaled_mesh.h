#pragma once

#include "geometry/bit_range.h"
#include "geometry/mesh.h"
#include "geometry/plane_filter.h"
#include "geometry/predicates.h"

namespace hsr::internal {

/// The power of two that brings the largest number near 1, or 2^0 if that would round the smallest away.
int scale_of(const BitRange& c);
/// Multiplied by 2^power. @pre no rounding: scale_of() tells
Point3 scaled(const Point3& p, int power);
BitRange scaled(const BitRange& c, int power);

/// A mesh with its points multiplied by one power of two, so that the largest coordinate is near 1 and scenes of any size pass the
/// filters alike; for what no view changes.
/// @pre mesh outlives it. Cost: O(n), parallel.
class ScaledMesh {
 public:
  explicit ScaledMesh(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  const Point3& point(VertexId v) const { return points_[v]; }
  Predicates predicates() const { return Predicates(bit_range_); }
  PlaneFilter filter(const Plane& plane) const { return {plane, filter_arithmetic_}; }
  Plane face_plane(TriangleId t) const {
    const auto& c = mesh_->triangles[t];
    return Plane::of_face(points_[c[0]], points_[c[1]], points_[c[2]]);
  }

 private:
  const Mesh* mesh_;
  IndexedVector<VertexId, Point3> points_;
  BitRange bit_range_;
  Arithmetic filter_arithmetic_;
};

}  // namespace hsr::internal
