#include "hsr/surfaces/visible_fragments.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/cancel.h"
#include "geometry/parallel.h"
#include "hsr/lines/appel.h"
#include "hsr/lines/behind_caps.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/roberts.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/cap_arrangement.h"
#include "hsr/surfaces/fragment_invariants.h"
#include "hsr/surfaces/fragment_observer.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/fragments_in_cells.h"
#include "hsr/surfaces/side_finder.h"

namespace hsr {

using namespace internal;

namespace {

using Range = tbb::blocked_range<std::size_t>;

class FragmentFinder {
 public:
  /// @param observer is told how; null: nobody is
  FragmentFinder(const SceneView& scene, const FragmentOptions& options, FragmentObserver* observer = nullptr)
      : options_(options),
        observer_(observer),
        parts_(scene.parts()),
        projected_(parts_.projected(options.stop)),
        mesh_(parts_.mesh()) {}

  VisibleFragments fragments();

 private:
  bool is_left_out(TriangleId t) const { return !left_out_->empty() && (*left_out_)[t.value] != 0; }
  bool has_many_borders() const;
  void find_lines();
  void find_own_lines(bool is_soup);
  void find_sides();
  void tell(FacetId facet, const Rings& rings) const;
  template <class F>
  void collect(std::span<const std::uint32_t> order, const F& visit);

  const FragmentOptions& options_;
  FragmentObserver* observer_;
  const ViewParts& parts_;
  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const std::vector<std::uint8_t>* left_out_ = nullptr;  // hidden or seen edge-on, by triangle
  const Occluders* occluders_ = nullptr;
  const Intersections* intersections_ = nullptr;
  const VisibleLines* lines_ = nullptr;   // of all edges of faces that are not left out, others may be among them
  VisibleLines own_lines_;                // these, unless they are given
  std::vector<std::uint32_t> place_;      // of each triangle along the tree of the occluders
  std::vector<FacetSides> found_;         // of each block of lines
  std::vector<const PlacedSide*> sides_;  // of these, by facet
  std::vector<std::size_t> first_side_;   // by TriangleId, one more
  DecisionCounts decisions_;
};

/// Whether more edges than there are faces occlude for certain, as they are borders: OccludingEdges would find no fewer.
bool FragmentFinder::has_many_borders() const {
  const auto is_counted = [&](TriangleId t) {
    const FaceId f = mesh_.face_of[t];
    if (is_left_out(t)) return false;
    for (std::uint32_t k = mesh_.first_triangle[f]; k < mesh_.first_triangle[FaceId(f.value + 1U)]; ++k)
      if (projected_.reaches_before_near(TriangleId(k))) return false;
    return true;
  };
  std::size_t borders = 0;
  for (std::size_t e = 0; e < mesh_.edges.size() && borders <= occluders_->triangles.size(); ++e) {
    const auto triangles = mesh_.triangles_at(EdgeId(e));
    if (triangles.size() == 1 && is_counted(triangles[0])) ++borders;
  }
  return borders > occluders_->triangles.size();
}

/// A face that is seen edge-on has no area in the image: it is left out, and its edges with it.
void FragmentFinder::find_lines() {
  left_out_ = &parts_.hidden_or_edge_on(options_.stop);
  occluders_ = &parts_.occluders(Excluded::hidden_and_edge_on, options_.stop);
  // Of a mesh few lines are looked along, as most edges have a face on each side: records may not pay.
  const bool is_soup = has_many_borders();
  if (is_soup) occluders_->prepare();
  intersections_ = &parts_.visible_intersections(options_.stop);
  // In lines of others a face seen edge-on hides what is behind it, here it hides nothing.
  if (options_.lines != nullptr && !parts_.has_edge_on(options_.stop)) {
    lines_ = options_.lines;
    if (lines_->plan.method != "appel") occluders_->prepare();
    return;
  }
  find_own_lines(is_soup);
  lines_ = &own_lines_;
}

void FragmentFinder::find_own_lines(bool is_soup) {
  const OcclusionPyramid* const tiles = parts_.pyramid(options_.stop);
  auto edges = parallel_collect<EdgeId>(mesh_.edges.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto triangles = mesh_.triangles_at(EdgeId(e));
      if (std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) { return !is_left_out(t); }) &&
          !(tiles != nullptr && tiles->hides(mesh_.edges[EdgeId(e)])))
        part.emplace_back(e);
    }
  });
  const ClassifiedEdges requested(projected_, std::move(edges));
  LineOptions line_options;
  line_options.stop = options_.stop;
  const bool may_count = projected_.arithmetic() == Arithmetic::staged && !is_soup;
  const bool appel_pays = may_count && parts_.occluding_edges(Excluded::hidden_and_edge_on, options_.stop).edges().size() <=
                                           occluders_->triangles.size();
  if (!appel_pays) occluders_->prepare();
  own_lines_ = appel_pays ? appel(projected_, requested, parts_.occluding_edges(Excluded::hidden_and_edge_on, options_.stop),
                                  *occluders_, line_options)
                          : roberts(projected_, requested, *occluders_, line_options, tiles);
  if (const SectionCaps* const caps = parts_.caps(options_.stop))
    own_lines_ = behind_caps(projected_, *caps, line_options, std::move(own_lines_));
}

/// The numbers from 0 to n - 1, ascending by key(i) < keys.
template <class Key>
std::vector<std::uint32_t> ordered(std::size_t n, std::size_t keys, const Key& key) {
  std::vector<std::uint32_t> next(keys + 1, 0), order(n);
  for (std::size_t i = 0; i < n; ++i) ++next[key(i) + 1];
  for (std::size_t k = 1; k <= keys; ++k) next[k] += next[k - 1];
  for (std::size_t i = 0; i < n; ++i) order[next[key(i)]++] = static_cast<std::uint32_t>(i);
  return order;
}

template <class F>
void FragmentFinder::collect(std::span<const std::uint32_t> order, const F& visit) {
  constexpr std::size_t block = 256;
  const std::size_t n = order.size();
  std::vector<FacetSides> parts((n + block - 1) / block);
  std::vector<DecisionCounts> counts(parts.size());
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      SideFinder finder(projected_, *occluders_, *intersections_, place_, parts_.pyramid(options_.stop),
                        parts_.caps(options_.stop), observer_);
      const std::size_t end = std::min((part + 1) * block, n);
      for (std::size_t i = part * block; i < end; ++i) visit(finder, order[i]);
      parts[part] = finder.take();
      counts[part] = finder.decisions();
    }
  });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    found_.push_back(std::move(parts[part]));
    decisions_ += counts[part];
  }
}

void FragmentFinder::find_sides() {
  // Along the tree: neighbours in the image look at the same triangles, which are still in the cache.
  place_.assign(mesh_.triangles.size(), 0);
  if (occluders_->is_prepared())
    for (std::size_t i = 0; i < occluders_->place().size(); ++i)
      place_[occluders_->triangles[i].value] = occluders_->place()[i];
  const auto along_tree = [&](std::vector<std::uint32_t> numbers, const auto& triangle) {
    const auto order =
        ordered(numbers.size(), place_.size(), [&](std::size_t i) { return place_[triangle(numbers[i]).value]; });
    std::vector<std::uint32_t> sorted(numbers.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = numbers[order[i]];
    return sorted;
  };
  const auto numbers = [](std::size_t n, const auto& is_kept) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < n; ++i)
      if (is_kept(i)) kept.push_back(static_cast<std::uint32_t>(i));
    return kept;
  };
  const auto& lines = lines_->lines;
  const auto& segments = intersections_->segments;
  const auto bounds_a_fragment = [&](std::size_t i) {
    if (lines[i].is_intersection() || lines[i].is_ghost || (lines[i].intervals() == 1 && lines[i].starts_hidden)) return false;
    const auto triangles = mesh_.triangles_at(lines[i].edge);
    return std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) { return !is_left_out(t); });
  };
  collect(along_tree(numbers(lines.size(), bounds_a_fragment),
                     [&](std::size_t i) { return mesh_.triangles_at(lines[i].edge).front(); }),
          [&](SideFinder& finder, std::size_t i) { finder.add_edge(*lines_, lines[i]); });
  collect(along_tree(numbers(segments.size(),
                             [&](std::size_t i) { return !is_left_out(segments[i].s) && !is_left_out(segments[i].t); }),
                     [&](std::size_t i) { return segments[i].s; }),
          [&](SideFinder& finder, std::size_t i) { finder.add_intersection(segments[i]); });
  if (projected_.has_near())
    collect(along_tree(numbers(occluders_->triangles.size(), [](std::size_t) { return true; }),
                       [&](std::size_t i) { return occluders_->triangles[i]; }),
            [&](SideFinder& finder, std::size_t i) { finder.add_near_cut(occluders_->triangles[i]); });
  if (const SectionCaps* const caps = parts_.caps(options_.stop)) {
    const CapArrangement arrangement(*caps);
    const auto runs =
        arrangement.runs([](const CapPart& part) { return part.left.empty() != part.right.empty(); },
                         [](const DirectedPart& a, const DirectedPart& b) { return a.left().empty() == b.left().empty(); });
    collect(numbers(runs.size(), [](std::size_t) { return true; }),
            [&](SideFinder& finder, std::size_t i) { finder.add_cap_border(arrangement, runs[i]); });
  }
  // A counting sort by facet.
  first_side_.assign(mesh_.triangles.size() + 1, 0);
  for (const FacetSides& part : found_)
    for (const FacetId facet : part.facets) ++first_side_[facet.value + 1U];
  for (std::size_t t = 1; t < first_side_.size(); ++t) first_side_[t] += first_side_[t - 1];
  sides_.resize(first_side_.back());
  std::vector<std::size_t> next(first_side_.begin(), first_side_.end() - 1);
  for (const FacetSides& part : found_)
    for (std::size_t i = 0; i < part.sides.size(); ++i) sides_[next[part.facets[i].value]++] = &part.sides[i];
}

void FragmentFinder::tell(FacetId facet, const Rings& rings) const {
  for (std::size_t k = 0; k + 1 < rings.first_ring.size(); ++k) {
    std::vector<std::span<const MapCorner>> of_region;
    for (std::uint32_t r = rings.first_ring[k]; r < rings.first_ring[k + 1]; ++r) of_region.push_back(rings.rings[r]);
    observer_->found(facet, of_region);
  }
}

VisibleFragments FragmentFinder::fragments() {
  if (mesh_.triangles.empty()) return {};
  find_lines();
  find_sides();
  struct Worker {
    MapPredicates at;
    RingLinker linker;
    std::vector<PlacedSide> sides;
    Worker(const ProjectedMesh& projected, FragmentObserver* observer) : at(projected), linker(at, observer) {}
    MapPredicates& map() { return at; }
  };
  VisibleFragments all = fragments_in_blocks(
      mesh_, options_, [&] { return Worker(projected_, observer_); },
      [&](Worker& worker, FacetId facet, FragmentParts& parts) {
        const std::size_t begin = first_side_[facet.value], end = first_side_[facet.value + 1U];
        if (begin == end) return;
        worker.sides.clear();
        for (std::size_t k = begin; k < end; ++k) worker.sides.push_back(*sides_[k]);
        if (observer_ != nullptr) observer_->linking(facet, worker.sides.size());
        const Rings& rings = worker.linker.link(worker.sides);
        if (observer_ != nullptr) tell(facet, rings);
        parts.add(facet, rings);
      });
  all.decisions += decisions_;
  all.decisions += own_lines_.decisions;
  all.decisions += intersections_->decisions;
#ifdef HSR_CHECKS
  if (projected_.arithmetic() != Arithmetic::double_only) check_invariants(projected_, all);  // it promises nothing
#endif
  return all;
}

}  // namespace

bool fragments_use_lines(const SceneView& scene) { return !scene.view().has_cells() && !scene.parts().has_edge_on(); }

VisibleFragments internal::visible_fragments(const SceneView& scene, const FragmentOptions& options,
                                             FragmentObserver& observer) {
  require(!scene.view().has_cells(), "visible_fragments: watched is a view without cells");
  VisibleFragments found;
  tbb::task_arena one_thread(1);
  one_thread.execute([&] { found = FragmentFinder(scene, options, &observer).fragments(); });
  return found;
}

VisibleFragments visible_fragments(const SceneView& scene, const FragmentOptions& options) {
  throw_if_stopped(options.stop);
  if (scene.view().has_cells()) return fragments_in_cells(scene, options);
  return FragmentFinder(scene, options).fragments();
}

}  // namespace hsr
