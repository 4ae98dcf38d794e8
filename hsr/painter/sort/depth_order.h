#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hsr/painter/sort/overlap_graph.h"

namespace hsr::internal {

/// The pieces from far to near by a key between the depths of each, and before a piece what it overlaps that is behind it
/// though its key is nearer. Nothing: there is no order, or too many pieces come before their turn.
///
/// Of two pieces whose depths are apart the nearer has the nearer key: whatever is behind a piece that comes in its turn was
/// there before, and no pair of these needs to be compared. A piece that comes before its turn is compared with all that its
/// box touches in the image. Most surfaces have few of these, and a hundred times as many pairs that are apart in depth.
///
/// @param boxes that touch in depth, too
/// @param found the pairs of these, none of which pierce each other; what else is compared is added to its counts
/// Exact: yes. Cost: O(n) and O(log n + k) for each piece before its turn with k boxes around it. The same for any number of
/// threads. Source: depth-first search for an order, Tarjan 1976; the key: Newell, Newell & Sancha 1972.
std::optional<std::vector<std::uint32_t>> depth_order(const ProjectedMesh& projected, const FacePieces& pieces,
                                                      const ClusterBoxes& boxes, const ImageTriangles& images,
                                                      OverlapGraph& found, SortObserver* observer = nullptr);

}  // namespace hsr::internal
