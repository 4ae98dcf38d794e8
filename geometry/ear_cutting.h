#pragma once

#include <span>
#include <vector>

#include "geometry/flat_orientation.h"
#include "geometry/triangulate.h"

namespace hsr::internal {

/// The plane of the coordinates that are left when one is dropped, turned so that the polygon in hand runs counter-clockwise.
struct FlatPlane {
  const IndexedVector<VertexId, Point3>& points;
  Predicates& predicates;
  int axis = 2;
  Sign turn = Sign::positive;  ///< negative: the polygon's normal has a negative component along the axis

  Sign orientation(VertexId a, VertexId b, VertexId c) const {
    return turn * normal_sign(points[a], points[b], points[c], axis, predicates);
  }
};

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
