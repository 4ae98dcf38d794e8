#pragma once

#include <vector>

#include "hsr/visibility_map/convex_piece.h"

namespace hsr::internal {

/// Which points of the facet of s a triangle t hides: those within all of some half-planes.
///
/// Of two that are in one plane it is the triangle; else where the triangle's plane is the nearer one within the triangle. Beyond
/// the near plane. @pre neither is seen edge-on
void shadow_on(const ProjectedMesh& projected, TriangleId t, TriangleId s, bool are_coplanar,
               std::vector<MapHalfPlane>& half_planes);

/// Takes from convex pieces what is within all of the half-planes: what is left of each is cut into convex pieces.
void subtract(MapPredicates& map, std::vector<ConvexPiece>& pieces, const std::vector<MapHalfPlane>& half_planes);

}  // namespace hsr::internal
