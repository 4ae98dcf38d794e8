#include "hsr/painter/sort/cluster_boxes.h"

#include "geometry/parallel.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

namespace {

ImageBox box_of(const MapPredicates& map, const FacePieces& pieces, std::size_t i) {
  ImageBox box = ImageBox::nothing();
  for (const VertexId v : pieces.rings[i]) box.add(map.projected().box(v, v));
  if (!pieces.rings[i].empty()) return box;
  for (const MapPoint& p : pieces.shape(map.projected(), i).points) {
    if (p.is_vertex) {
      box.add(map.projected().box(p.vertex, p.vertex));
    } else {
      const BoundedPoint3 at = map.point(p, pieces.facet[i]);
      box.add(map.projected().box(at.p, 3 * at.error));
    }
  }
  return box;
}

}  // namespace

ClusterBoxes::ClusterBoxes(const ProjectedMesh& projected, const FacePieces& pieces, const Clusters& clusters,
                           InDepth looked_for)
    : clusters_(clusters), looked_for_(looked_for), boxes_(pieces.size()), tree_of_(clusters.size(), nullptr) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes_.size(), 1024), [&](const auto& range) {
    const MapPredicates map(projected);
    for (std::size_t i = range.begin(); i != range.end(); ++i) boxes_[i] = box_of(map, pieces, clusters.values()[i]);
  });
  std::vector<ImageBox> flat;
  if (looked_for == InDepth::apart) {
    flat = boxes_;
    for (ImageBox& box : flat) box.farthest = box.nearest = 0;
  }
  const std::span<const ImageBox> boxes = looked_for == InDepth::apart ? flat : boxes_;
  constexpr std::size_t small = 64;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const std::size_t first = clusters.begin(c), count = clusters[c].size();
    if (count > small) tree_of_[c] = &trees_.emplace_back(boxes.subspan(first, count));
  }
}

}  // namespace hsr::internal
