#include "hsr/painter/overlap_graph.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <deque>

#include "hsr/painter/whole_overlap.h"

namespace hsr {

namespace {

ImageBox box_of(const MapSight& map, const FacePieces& pieces, std::size_t i) {
  ImageBox box = ImageBox::nothing();
  for (const VertexId v : pieces.ring(i)) box.add(map.sight().box(v, v));
  if (!pieces.ring(i).empty()) return box;
  for (const MapPoint& p : pieces.shape(map.sight(), i).points) {
    if (p.is_vertex) {
      box.add(map.sight().box(p.vertex, p.vertex));
    } else {
      const NearPoint at = map.point(p, pieces.facet[i]);
      box.add(map.sight().box(at.p, 3 * at.error));
    }
  }
  return box;
}

/// The relations of one piece after another with later ones: of whole pieces where vertices tell, else of their shapes.
class Relations {
 public:
  Relations(const Sight& sight, const FacePieces& pieces, const ImageTriangles& images, bool classic)
      : sight_(sight), pieces_(pieces), overlaps_(sight, classic), whole_(sight, pieces, images) {}

  Overlap relation(std::uint32_t i, std::uint32_t k) {
    if (i != first_) turn_to(i);
    if (is_whole_ && !pieces_.ring(k).empty())
      if (const auto how = whole_.relation(k)) return *how;
    if (shape_.shape.points.empty()) shape_ = shape(i);
    return overlaps_.relation(shape_, shape(k));
  }

  OverlapCounts counts() const {
    OverlapCounts all = overlaps_.counts();
    all += whole_.counts();
    return all;
  }
  DecisionCounts decisions() {
    DecisionCounts all = overlaps_.map().exact().counts();
    all += whole_.decisions();
    return all;
  }

 private:
  void turn_to(std::uint32_t i) {
    first_ = i;
    shape_ = {};
    is_whole_ = !pieces_.ring(i).empty();
    if (is_whole_) whole_.turn_to(i);
  }
  PieceOfFacet shape(std::uint32_t i) const {
    PieceOfFacet piece{pieces_.facet[i], pieces_.shape(sight_, i)};
    piece.near = overlaps_.near_corners(piece);
    return piece;
  }

  const Sight& sight_;
  const FacePieces& pieces_;
  Overlaps overlaps_;
  WholeOverlaps whole_;
  std::uint32_t first_ = 0xffffffffU;
  bool is_whole_ = false;
  PieceOfFacet shape_;  // of the first
};

/// Finds the overlapping pairs of some clusters.
class Finder {
 public:
  Finder(const Sight& sight, const FacePieces& pieces, const ImageTriangles& images, bool classic)
      : pieces_(pieces), relations_(sight, pieces, images, classic) {}

  void look_at(std::uint32_t i, std::uint32_t k) {
    if (pieces_.facet[i] == pieces_.facet[k]) return;
    ++found_.candidates;
    const Overlap how = relations_.relation(i, k);
    if (how == Overlap::none) return;
    if (how == Overlap::second_behind) std::swap(i, k);
    pairs_.push_back({i, k});
    if (how == Overlap::piercing) found_.piercing.push_back({i, k});
  }
  OverlapGraph take() {
    found_.overlapping = pairs_.size();
    found_.pairs.push_back(std::move(pairs_));
    found_.counts = relations_.counts();
    found_.decisions = relations_.decisions();
    return std::move(found_);
  }

 private:
  const FacePieces& pieces_;
  Relations relations_;
  OverlapGraph found_;
  std::vector<Overlapping> pairs_;
};

bool overlap(const ImageBox& x, const ImageBox& y) {
  return x.low[0] <= y.high[0] && y.low[0] <= x.high[0] && x.low[1] <= y.high[1] && y.low[1] <= x.high[1];
}

/// Leaves of the tree of a large cluster, or some small clusters.
struct Work {
  std::size_t first_cluster = 0, end_cluster = 0;
  const BoxTree* tree = nullptr;
  std::uint32_t first_leaf = 0, end_leaf = 0;
};

}  // namespace

OverlapGraph overlap_graph(const Sight& sight, const FacePieces& pieces, const Clusters& clusters, bool classic) {
  std::vector<ImageBox> boxes(pieces.size());  // by place in the clusters
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 1024), [&](const auto& range) {
    const MapSight map(sight);
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      boxes[i] = box_of(map, pieces, clusters.pieces[i]);
      boxes[i].farthest = boxes[i].nearest = 0;  // depth does not matter: without it the tree is the finer in the image
    }
  });
  constexpr std::size_t small = 64, block = 64, leaves = 64;  // block: of small clusters
  std::deque<BoxTree> trees;
  std::vector<Work> work;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const std::size_t first = clusters.first[c], count = clusters.first[c + 1] - first;
    if (count <= small) {
      if (work.empty() || work.back().tree != nullptr || c - work.back().first_cluster == block) work.push_back({c, c});
      work.back().end_cluster = c + 1;
      continue;
    }
    const BoxTree& tree = trees.emplace_back(std::span(boxes).subspan(first, count));
    for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); leaf += leaves)
      work.push_back({c, c + 1, &tree, leaf, std::min<std::uint32_t>(leaf + leaves, tree.leaf_count())});
  }
  const ImageTriangles images = image_triangles(sight, pieces);
  std::vector<OverlapGraph> parts(work.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      const Work& w = work[part];
      Finder finder(sight, pieces, images, classic);
      const auto look_at = [&](std::size_t i, std::size_t k) { finder.look_at(clusters.pieces[i], clusters.pieces[k]); };
      BoxTree::PairSearch search;
      const std::size_t first = clusters.first[w.first_cluster];
      for (std::uint32_t leaf = w.first_leaf; leaf < w.end_leaf; ++leaf)
        w.tree->visit_pairs<BoxTree::Depth::any>(leaf, search,
                                                 [&](std::uint32_t i, std::uint32_t k) { look_at(first + i, first + k); });
      for (std::size_t c = w.first_cluster; w.tree == nullptr && c < w.end_cluster; ++c)
        for (std::size_t i = clusters.first[c]; i < clusters.first[c + 1]; ++i)
          for (std::size_t k = i + 1; k < clusters.first[c + 1]; ++k)
            if (overlap(boxes[i], boxes[k])) look_at(i, k);
      parts[part] = finder.take();
    }
  });
  OverlapGraph all;
  for (OverlapGraph& part : parts) {
    all.pairs.push_back(std::move(part.pairs.front()));
    all.piercing.insert(all.piercing.end(), part.piercing.begin(), part.piercing.end());
    all.candidates += part.candidates;
    all.overlapping += part.overlapping;
    all.counts += part.counts;
    all.decisions += part.decisions;
  }
  return all;
}

}  // namespace hsr
