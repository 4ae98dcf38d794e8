#pragma once

#include <array>

#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

/// A line and the side of it that counts: positive, to its left.
struct MapHalfPlane {
  MapLine line;
  Sign inner;
};

/// The side of a triangle from corner k to the next, and on which side of it the triangle lies, as seen.
inline MapHalfPlane side_of_triangle(const ProjectedMesh& projected, TriangleId t, std::size_t k) {
  const auto& c = projected.mesh().triangles[t];
  const VertexId u = c[k], v = c[(k + 1) % 3];
  const Sign facing = projected.facing(t);
  return {MapLine::edge(u, v), u < v ? facing : -facing};
}

/// What is beyond the near plane, in the plane of a triangle that is not parallel to it.
inline MapHalfPlane beyond_near(const ProjectedMesh& projected, TriangleId t) {
  return {MapLine::near(t), projected.facing(t)};
}

}  // namespace hsr::internal
