#include "hsr/painter/sort/overlap_graph.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "geometry/cancel.h"
#include "geometry/watched.h"
#include "hsr/painter/sort/piece_relations.h"

namespace hsr::internal {

namespace {

/// Finds the overlapping pairs of some clusters.
template <class Watch>
class Finder {
 public:
  Finder(const ProjectedMesh& projected, const FacePieces& pieces, const ImageTriangles& images, bool classic, Watch watch)
      : watch_(watch), pieces_(pieces), relations_(projected, pieces, images, classic) {}

  void look_at(std::uint32_t i, std::uint32_t k) {
    if (pieces_.facet[i] == pieces_.facet[k]) return;
    ++found_.candidates;
    const Overlap how = relation(i, k);
    if (how == Overlap::none) return;
    if (how == Overlap::second_behind) std::swap(i, k);
    pairs_.push_back({i, k});
    if (how == Overlap::piercing) found_.piercing.push_back({i, k});
  }
  OverlapGraph take() {
    found_.overlapping = pairs_.size();
    if (!pairs_.empty()) found_.pairs.push_back(std::move(pairs_));
    found_.counts = relations_.counts();
    found_.decisions = relations_.decisions();
    return std::move(found_);
  }

 private:
  Overlap relation(std::uint32_t i, std::uint32_t k) {
    if constexpr (Watch::is_watched)
      return relations_.relation(i, k, *watch_.observer);
    else
      return relations_.relation(i, k);
  }

  [[no_unique_address]] Watch watch_;
  const FacePieces& pieces_;
  PieceRelations relations_;
  OverlapGraph found_;
  std::vector<Overlapping> pairs_;
};

/// Leaves of the tree of a large cluster, or some small clusters.
struct Work {
  std::size_t first_cluster = 0, end_cluster = 0;
  const BoxTree* tree = nullptr;
  std::uint32_t first_leaf = 0, end_leaf = 0;
};

}  // namespace

void OverlapGraph::add(OverlapGraph&& more) {
  for (std::vector<Overlapping>& part : more.pairs) pairs.push_back(std::move(part));
  piercing.insert(piercing.end(), more.piercing.begin(), more.piercing.end());
  candidates += more.candidates;
  overlapping += more.overlapping;
  counts += more.counts;
  decisions += more.decisions;
}

namespace {

template <class Watch>
OverlapGraph found(const ProjectedMesh& projected, const FacePieces& pieces, const ClusterBoxes& boxes,
                   const ImageTriangles& images, bool classic, const std::stop_token& stop, Watch watch) {
  constexpr std::size_t block = 64, leaves = 64;  // block: of small clusters
  const Clusters& clusters = boxes.clusters();
  const bool touching = boxes.looked_for() == InDepth::touching;
  std::vector<Work> work;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const BoxTree* const tree = boxes.tree(c);
    if (tree == nullptr) {
      if (work.empty() || work.back().tree != nullptr || c - work.back().first_cluster == block) work.push_back({c, c});
      work.back().end_cluster = c + 1;
      continue;
    }
    for (std::uint32_t leaf = 0; leaf < tree->leaf_count(); leaf += leaves)
      work.push_back({c, c + 1, tree, leaf, std::min<std::uint32_t>(leaf + leaves, tree->leaf_count())});
  }
  std::vector<OverlapGraph> parts(work.size());
  const auto find = [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      throw_if_stopped(stop);
      const Work& w = work[part];
      Finder<Watch> finder(projected, pieces, images, classic, watch);
      const auto look_at = [&](std::size_t i, std::size_t k) { finder.look_at(clusters.values()[i], clusters.values()[k]); };
      BoxTree::PairSearch search;
      const std::size_t first = clusters.begin(w.first_cluster);
      for (std::uint32_t leaf = w.first_leaf; leaf < w.end_leaf; ++leaf) {
        if (touching)
          w.tree->visit_pairs<BoxTree::Depth::touching>(
              leaf, search, [&](std::uint32_t i, std::uint32_t k) { look_at(first + i, first + k); });
        else
          w.tree->visit_pairs<BoxTree::Depth::any>(leaf, search, [&](std::uint32_t i, std::uint32_t k) {
            if (!touch_in_depth(boxes[first + i], boxes[first + k])) look_at(first + i, first + k);
          });
      }
      for (std::size_t c = w.first_cluster; w.tree == nullptr && c < w.end_cluster; ++c)
        for (std::size_t i = clusters.begin(c); i < clusters.begin(c + 1); ++i)
          for (std::size_t k = i + 1; k < clusters.begin(c + 1); ++k)
            if (touch_in_image(boxes[i], boxes[k]) && touch_in_depth(boxes[i], boxes[k]) == touching) look_at(i, k);
      parts[part] = finder.take();
    }
  };
  const tbb::blocked_range<std::size_t> all_parts(0, parts.size(), 1);
  if constexpr (Watch::is_watched)
    find(all_parts);
  else
    tbb::parallel_for(all_parts, find);
  OverlapGraph all;
  for (OverlapGraph& part : parts) all.add(std::move(part));
  return all;
}

}  // namespace

OverlapGraph overlap_graph(const ProjectedMesh& projected, const FacePieces& pieces, const ClusterBoxes& boxes,
                           const ImageTriangles& images, bool classic, const std::stop_token& stop, SortObserver* observer) {
  if (observer != nullptr) return found(projected, pieces, boxes, images, classic, stop, Watched<SortObserver>{observer});
  return found(projected, pieces, boxes, images, classic, stop, Unwatched{});
}

}  // namespace hsr::internal
