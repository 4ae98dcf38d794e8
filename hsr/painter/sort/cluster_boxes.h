#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "hsr/painter/sort/clusters.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// Which pairs are looked for.
enum class InDepth : std::uint8_t {
  touching,  ///< boxes that touch in depth, too
  apart,     ///< boxes that touch in the image only
};

/// The boxes of pieces, and for each large cluster a tree of them. Pieces are named by their places in the clusters.
class ClusterBoxes {
 public:
  /// @param looked_for trees for boxes that are apart know no depth: then neighbours in them are closer in the image
  /// Cost: O(n log n), parallel.
  ClusterBoxes(const ProjectedMesh& projected, const FacePieces& pieces, const Clusters& clusters, InDepth looked_for);

  const Clusters& clusters() const { return clusters_; }
  InDepth looked_for() const { return looked_for_; }
  const ImageBox& operator[](std::size_t place) const { return boxes_[place]; }
  /// Null: the cluster is small, and every two pieces of it may be tried.
  const BoxTree* tree(std::size_t cluster) const { return tree_of_[cluster]; }

 private:
  const Clusters& clusters_;
  InDepth looked_for_;
  std::vector<ImageBox> boxes_;
  std::deque<BoxTree> trees_;
  std::vector<const BoxTree*> tree_of_;
};

/// Whether the boxes have something in common in the image; what they may have in common in depth, too.
inline bool touch_in_image(const ImageBox& x, const ImageBox& y) {
  return x.low[0] <= y.high[0] && y.low[0] <= x.high[0] && x.low[1] <= y.high[1] && y.low[1] <= x.high[1];
}
inline bool touch_in_depth(const ImageBox& x, const ImageBox& y) { return x.farthest <= y.nearest && y.farthest <= x.nearest; }

}  // namespace hsr::internal
