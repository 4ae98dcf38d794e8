#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/painter/sort/face_pieces.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The facets of some pieces, ascending, if these are all pieces of each of them; else none.
/// @param pieces ascending; numbers beyond those of `all` are parts of pieces that were cut
std::vector<FacetId> whole_facets(const FacePieces& all, const std::vector<std::uint32_t>& pieces);

struct TreeOrder {
  PaintersOrder order;
  std::uint64_t splits = 0;
};

/// Some facets far to near, by planes in space: a tree divides by planes across axes, too, and its corners are meets of planes of the
/// input, which cost less to compare than those of the image.
/// @param pieces_before that depth sort has made, of the most that are allowed
/// @throws InputError beyond the most pieces, CancelledError if asked to stop
/// Exact: yes. Cost: as BspTree.
TreeOrder ordered_by_tree(const ProjectedMesh& projected, const View& view, const std::vector<FacetId>& facets,
                          std::size_t pieces_before, std::size_t most_pieces, const std::stop_token& stop);

/// Appends one order to another. @throws InputError beyond 2^32 - 1 corners
void append(const PaintersOrder& part, PaintersOrder& all);

}  // namespace hsr::internal
