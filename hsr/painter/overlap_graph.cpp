#include "hsr/painter/overlap_graph.h"

#include <tbb/parallel_for.h>

#include "hsr/parallel.h"

namespace hsr {

ImageBox box_of(const MapSight& map, const PieceOfFacet& piece) {
  ImageBox box = ImageBox::nothing();
  for (const MapPoint& p : piece.shape.points) {
    if (p.is_vertex) {
      box.add(map.sight().box(p.vertex, p.vertex));
    } else {
      const NearPoint at = map.point(p, piece.facet);
      box.add(map.sight().box(at.p, 3 * at.error));
    }
  }
  return box;
}

OverlapGraph overlap_graph(const Sight& sight, std::span<const PieceOfFacet> pieces, bool classic) {
  std::vector<ImageBox> boxes(pieces.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 1024), [&](const auto& range) {
    const MapSight map(sight);
    for (std::size_t i = range.begin(); i != range.end(); ++i) boxes[i] = box_of(map, pieces[i]);
  });
  const BoxTree tree(boxes);
  constexpr std::size_t block = 64;
  std::vector<OverlapGraph> parts((tree.leaf_count() + block - 1) / block);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      OverlapGraph& found = parts[part];
      Overlaps overlaps(sight, classic);
      std::vector<std::uint32_t> leaves;
      const std::size_t end = std::min<std::size_t>((part + 1) * block, tree.leaf_count());
      for (std::size_t leaf = part * block; leaf < end; ++leaf)
        tree.visit_pairs<BoxTree::Depth::any>(static_cast<std::uint32_t>(leaf), leaves, [&](std::uint32_t i, std::uint32_t k) {
          if (pieces[i].facet == pieces[k].facet) return;
          ++found.candidates;
          const Overlap how = overlaps.relation(pieces[i], pieces[k]);
          if (how == Overlap::none) return;
          if (how == Overlap::second_behind) std::swap(i, k);
          found.pairs.push_back({i, k, how == Overlap::piercing});
        });
      found.counts = overlaps.counts();
      found.decisions = overlaps.map().exact().counts();
    }
  });
  OverlapGraph all;
  for (const OverlapGraph& part : parts) {
    all.pairs.insert(all.pairs.end(), part.pairs.begin(), part.pairs.end());
    all.candidates += part.candidates;
    all.counts += part.counts;
    all.decisions += part.decisions;
  }
  return all;
}

}  // namespace hsr
