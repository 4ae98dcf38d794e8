#pragma once

#include <cstdint>
#include <vector>

#include "hsr/painter/sort/face_pieces.h"

namespace hsr::internal {

/// Pieces in groups that may be painted one after another: planes that no piece crosses part them, and what lies beyond such a
/// plane, as seen from the viewpoint, hides nothing on its own side. What is in one group still has to be sorted.
/// A row for each group, these from far to near; ascending in each.
using Clusters = Ragged<std::uint32_t>;

/// Looks for planes across the axes, and again within what they leave, as long as there are more than a few pieces. Of touching
/// pieces none is found.
/// Exact: yes: coordinates are compared. Cost: O(n) for each time that planes are found. The same for any number of threads.
/// Source: Schumacker, Brand, Gilliland & Sharp 1969.
Clusters clusters(const ProjectedMesh& projected, const FacePieces& pieces);

/// All of them in one.
Clusters one_cluster(const FacePieces& pieces);

/// By piece: the cluster that it is in.
std::vector<std::uint32_t> cluster_of_pieces(const Clusters& clusters);

}  // namespace hsr::internal
