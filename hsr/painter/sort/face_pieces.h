#pragma once

#include <cstdint>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/visibility_map/convex_piece.h"

namespace hsr::internal {

/// All facets that are not seen edge-on, beyond the near plane, as convex pieces, ascending by facet: one of a convex facet, or
/// one of each of its triangles. A piece that nothing has cut is no more than its vertices: most scenes need no other.
struct FacePieces {
  std::vector<FacetId> facet;          // by piece
  Ragged<VertexId> rings;              // by piece, as the triangles of the facet run; empty: the near plane has cut it
  std::vector<std::uint32_t> cut;      // ascending: the pieces that the near plane has cut
  std::vector<ConvexPiece> cut_shape;  // by place in `cut`

  std::size_t size() const { return facet.size(); }
  /// The piece by its sides, as it is seen.
  ConvexPiece shape(const ProjectedMesh& projected, std::size_t piece) const;
};

/// Exact: yes. Cost: O(n), parallel.
FacePieces face_pieces(const ProjectedMesh& projected);

}  // namespace hsr::internal
