#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hsr/visibility_map/map_predicates.h"
#include "hsr/visibility_map/triangle_sides.h"

namespace hsr::internal {

/// A convex part of a facet in the image, counter-clockwise: side k runs along its line from point k to point k + 1. Never
/// rounded, however often it is cut. (Plane-based polygons: Sugihara & Iri 1989; Bernstein & Fussell 2009.)
struct ConvexPiece {
  std::vector<MapHalfPlane> lines;  // all inner to the left as the side runs
  std::vector<MapPoint> points;
};

/// A triangle that is not seen edge-on.
ConvexPiece convex_piece(const ProjectedMesh& projected, TriangleId t);

/// A convex ring of vertices of the facet of t, as its triangles run.
ConvexPiece convex_piece(const ProjectedMesh& projected, TriangleId t, std::span<const VertexId> ring);

/// A facet that is not seen edge-on, beyond the near plane: one piece if it is convex, or one of each triangle.
std::vector<ConvexPiece> convex_pieces(MapPredicates& map, FacetId facet);

/// Cuts the piece: what is inside the half-plane stays, what is outside is returned. Exact.
std::optional<ConvexPiece> cut(MapPredicates& map, ConvexPiece& piece, const MapHalfPlane& h);

}  // namespace hsr::internal
