#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "hsr/painter/sort/cluster_boxes.h"
#include "hsr/painter/sort/image_triangle.h"
#include "hsr/painter/sort/overlap.h"

namespace hsr::internal {

class SortObserver;

/// Two pieces whose images overlap. Where they do not pierce each other the first is painted first.
struct Overlapping {
  std::uint32_t first, second;
};

struct OverlapGraph {
  std::vector<std::vector<Overlapping>>
      pairs;                          ///< in parts as they were found: by cluster, in the order of a tree of the image
  std::vector<Overlapping> piercing;  ///< of all pairs those that pierce each other
  std::uint64_t candidates = 0;       ///< pairs whose boxes overlap in the image
  std::uint64_t overlapping = 0;      ///< all pairs
  OverlapCounts counts;
  DecisionCounts decisions;

  void add(OverlapGraph&& more);
  template <class F>
  void for_each_pair(const F& visit) const {
    for (const std::vector<Overlapping>& part : pairs)
      for (const Overlapping& pair : part) visit(pair.first, pair.second);
  }
};

/// Which pieces of one cluster overlap, and how, of those whose boxes touch as the trees of boxes look for.
/// @param classic call piercing every pair that no plane of the two separates
/// @param observer is told of each pair, in one thread; null: nobody is
/// Exact: yes. Cost: O(n + k log n) for k pairs of boxes, parallel.
OverlapGraph overlap_graph(const ProjectedMesh& projected, const FacePieces& pieces, const ClusterBoxes& boxes,
                           const ImageTriangles& images, bool classic, const std::stop_token& stop,
                           SortObserver* observer = nullptr);

}  // namespace hsr::internal
