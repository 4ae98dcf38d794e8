#pragma once

#include <span>
#include <vector>

#include "geometry/flat_plane.h"
#include "geometry/triangulate.h"

namespace hsr::internal {

struct EarCutting {
  std::vector<FaceTriangle> triangles;
  bool only_ears =
      true;  ///< every triangle is an ear by the first two rules, and their sides match: the polygon's area, signed
};

/// Rule 4 of triangulate.h. @pre `polygon` is reduced
EarCutting cut_ears(const FlatPlane& plane, std::span<const VertexId> polygon);

/// Whether the insides of the triangles of a polygon that was cut by ears only are pairwise disjoint. Exact.
bool is_free_of_overlap(const FlatPlane& plane, std::span<const VertexId> polygon, std::span<const FaceTriangle> triangles);

}  // namespace hsr::internal
