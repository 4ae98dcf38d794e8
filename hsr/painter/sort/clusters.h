#pragma once

#include <cstdint>
#include <vector>

#include "hsr/painter/sort/face_pieces.h"

namespace hsr::internal {

/// Pieces in groups that may be painted one after another: planes that no piece crosses part them, and what lies beyond such a
/// plane, as seen from the viewpoint, hides nothing on its own side. What is in one group still has to be sorted.
struct Clusters {
  std::vector<std::uint32_t> pieces;       // by cluster, these from far to near; ascending in each
  std::vector<std::uint32_t> first = {0};  // by cluster, one more

  std::size_t size() const { return first.size() - 1; }
  /// By piece.
  std::vector<std::uint32_t> cluster_of() const;
};

/// Looks for planes across the axes, and again within what they leave, as long as there are more than a few pieces. Of touching
/// pieces none is found.
/// Exact: yes: coordinates are compared. Cost: O(n) for each time that planes are found. The same for any number of threads.
/// Source: Schumacker, Brand, Gilliland & Sharp 1969.
Clusters clusters(const ProjectedMesh& projected, const FacePieces& pieces);

/// All of them in one.
Clusters one_cluster(const FacePieces& pieces);

}  // namespace hsr::internal
