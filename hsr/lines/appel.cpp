#include "hsr/lines/appel.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <span>

#include "geometry/error.h"
#include "geometry/weighted_disjoint_sets.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/count_observer.h"
#include "hsr/lines/hidden_intervals.h"
#include "hsr/lines/invisibility_count.h"
#include "hsr/lines/invisibility_events.h"
#include "hsr/lines/line_progress.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;

/// How many triangles are in front of an edge just inside one of its ends, to the left and to the right of the edge.
struct Sides {
  std::int32_t left = 0, right = 0;
};

struct Part {
  std::vector<EdgeWalk> walks;
  std::vector<std::uint32_t> first_change;  // one more
  std::vector<InvisibilityChange> changes;
  // Of the triangles at the ends, just inside.
  std::vector<Sides> at_start, at_end;
  DecisionCounts decisions;
  std::uint64_t pairs = 0;
};

class Appel {
 public:
  Appel(const ProjectedMesh& projected, const ClassifiedEdges& requested, const OccludingEdges& layers,
        const Occluders& occluders, const LineOptions& options, CountObserver* observer)
      : options_(options),
        observer_(observer),
        projected_(projected),
        requested_(requested),
        layers_(layers),
        occluders_(occluders),
        order_(hilbert_order(requested_.boxes)),
        parts_((order_.size() + edges_of_block - 1) / edges_of_block),
        counts_(projected.mesh().points.size()) {}

  VisibleLines lines() {
    if (observer_ != nullptr) observer_->occluding(layers_.edges());
    LineProgress progress(options_.progress, options_.stop, 2 * order_.size());
    for_each_part([&](std::size_t part, std::size_t begin, std::size_t end) {
      find_courses(parts_[part], begin, end);
      progress.advance(end - begin);
    });
    carry_on();
    count_roots();
    std::vector<VisibleLines> lines(parts_.size());
    std::vector<std::array<std::uint32_t, 2>> place(order_.size());
    for_each_part([&](std::size_t part, std::size_t begin, std::size_t end) {
      lines[part] = tiled(parts_[part], begin, end);
      for (std::size_t k = begin; k < end; ++k)
        place[order_[k]] = {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k - begin)};
      progress.advance(end - begin);
    });
    VisibleLines all = joined(lines, place);
    all.decisions += requested_.decisions;
    all.decisions += root_decisions_;
    for (const Part& part : parts_) {
      all.decisions += part.decisions;
      all.pairs += part.pairs;
    }
    return all;
  }

 private:
  template <class F>
  void for_each_part(const F& visit) const {
    if (observer_ != nullptr) {
      for (std::size_t part = 0; part < parts_.size(); ++part)
        visit(part, part * edges_of_block, std::min((part + 1) * edges_of_block, order_.size()));
      return;
    }
    tbb::parallel_for(Range(0, parts_.size(), 1), [&](const Range& range) {
      for (std::size_t part = range.begin(); part < range.end(); ++part)
        visit(part, part * edges_of_block, std::min((part + 1) * edges_of_block, order_.size()));
    });
  }
  bool is_hidden(std::size_t k) const { return !requested_.hidden.empty() && requested_.hidden[order_[k]] != 0; }
  const Edge& edge(std::size_t k) const { return projected_.mesh().edges[requested_.edges[order_[k]]]; }

  void find_courses(Part& part, std::size_t begin, std::size_t end) const;
  Sides at_vertex(InvisibilityCount& count, VertexId v, VertexId to) const;
  void carry_on();
  void count_roots();
  void tell_counts(std::span<const VertexId> rayed);
  Sides start(const Part& part, std::size_t i, const Edge& e, InvisibilityCount& count) const;
  VisibleLines tiled(const Part& part, std::size_t begin, std::size_t end) const;
  void add_shadows(TriangleOcclusion& occlusion, std::span<const InvisibilityChange> changes, Sides layers,
                   std::vector<HiddenInterval>& hidden) const;

  const LineOptions& options_;
  CountObserver* observer_;
  const ProjectedMesh& projected_;
  const ClassifiedEdges& requested_;
  const OccludingEdges& layers_;
  const Occluders& occluders_;
  std::vector<std::uint32_t> order_;
  std::vector<Part> parts_;
  WeightedDisjointSets counts_;
  std::vector<std::int32_t> before_;  // by vertex, where it is clean: the triangles in front of it, without those at it
  DecisionCounts root_decisions_;
};

Sides Appel::at_vertex(InvisibilityCount& count, VertexId v, VertexId to) const {
  if (layers_.is_plain(v)) return {};
  return {count.at_vertex(v, to, Sign::positive), count.at_vertex(v, to, Sign::negative)};
}

void Appel::find_courses(Part& part, std::size_t begin, std::size_t end) const {
  InvisibilityEvents crossings(projected_, layers_, occluders_);
  InvisibilityCount count(projected_, layers_);
  part.first_change.push_back(0);
  constexpr std::size_t group = 16;
  std::vector<ImageBox> boxes;
  for (std::size_t k = begin; k < end; ++k) {
    if ((k - begin) % group == 0) {
      boxes.clear();
      for (std::size_t i = k; i < std::min(k + group, end); ++i) boxes.push_back(requested_.boxes[order_[i]]);
      crossings.turn_to(boxes);
    }
    const EdgeId id = requested_.edges[order_[k]];
    EdgeWalk walk;
    if (is_hidden(k))
      walk.is_hidden = true;
    else if (requested_.is_part(order_[k]))
      walk.is_degenerate = true;
    else
      walk = crossings.find(id, boxes[(k - begin) % group], part.changes);
    part.walks.push_back(walk);
    check_countable(part.changes.size(), "crossings of neighbouring edges");
    if (observer_ != nullptr) observer_->looked_along(id, walk, std::span(part.changes).subspan(part.first_change.back()));
    part.first_change.push_back(static_cast<std::uint32_t>(part.changes.size()));
    Sides at_start, at_end;
    if (walk.is_followed()) {
      const Edge& e = projected_.mesh().edges[id];
      at_start = at_vertex(count, e.a, e.b);
      at_end = at_vertex(count, e.b, e.a);
      std::swap(at_end.left, at_end.right);  // seen from b, the other way round
    }
    part.at_start.push_back(at_start);
    part.at_end.push_back(at_end);
  }
  part.decisions += crossings.decisions();
  part.decisions += count.decisions();
  part.pairs = crossings.pairs();
}

/// The number of triangles in front of a clean vertex, without those at it, is the same for all of its edges.
void Appel::carry_on() {
  const auto carry = [&](std::size_t p, std::size_t begin, std::size_t end) {
    const Part& part = parts_[p];
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = k - begin;
      const EdgeWalk& c = part.walks[i];
      if (!c.is_followed() || !c.start_is_clean || !c.end_is_clean) continue;
      const Edge& e = edge(k);
      const std::int32_t left = part.at_start[i].left + c.left - part.at_end[i].left;
      const bool agrees = counts_.join(e.a.value, e.b.value, left);
#ifdef HSR_CHECKS
      if (projected_.arithmetic() != Arithmetic::double_only &&
          (!agrees || left != part.at_start[i].right + c.right - part.at_end[i].right))
        throw InvariantError("appel: the layers along edges contradict each other");
#else
      static_cast<void>(agrees);
#endif
    }
  };
  if (projected_.arithmetic() != Arithmetic::double_only) {
    for_each_part(carry);
    return;
  }
  // Doubles may contradict each other, and then the first word counts.
  for (std::size_t p = 0; p < parts_.size(); ++p)
    carry(p, p * edges_of_block, std::min((p + 1) * edges_of_block, order_.size()));
}

/// One query for each connected part: at the clean end of its first edge in order.
void Appel::count_roots() {
  constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> first_edge(projected_.mesh().points.size(), none);  // by root
  const auto clean_end = [&](std::size_t k) {
    const Edge& e = edge(k);
    const bool from_start = parts_[k / edges_of_block].walks[k % edges_of_block].start_is_clean;
    return from_start ? std::pair(e.a, e.b) : std::pair(e.b, e.a);
  };
  for_each_part([&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const EdgeWalk& c = parts_[part].walks[k - begin];
      if (!c.is_followed() || (!c.start_is_clean && !c.end_is_clean)) continue;
      const std::atomic_ref first(first_edge[counts_.find(clean_end(k).first.value).root]);
      const auto own = static_cast<std::uint32_t>(k);
      std::uint32_t seen = first.load(std::memory_order_relaxed);
      while (own < seen && !first.compare_exchange_weak(seen, own, std::memory_order_relaxed)) {
      }
    }
  });
  std::vector<std::uint32_t> roots;
  for (std::size_t v = 0; v < first_edge.size(); ++v)
    if (first_edge[v] != none) roots.push_back(static_cast<std::uint32_t>(v));
  std::vector<std::int32_t> root_count(first_edge.size(), 0);
  constexpr std::size_t block = 64;
  std::vector<DecisionCounts> decisions((roots.size() + block - 1) / block);
  tbb::parallel_for(Range(0, decisions.size(), 1), [&](const Range& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      InvisibilityCount count(projected_, layers_);
      for (std::size_t r = k * block; r < std::min(roots.size(), (k + 1) * block); ++r) {
        const auto [from, to] = clean_end(first_edge[roots[r]]);
        root_count[roots[r]] = count.before(from, to, Sign::positive, occluders_) - counts_.find(from.value).above;
      }
      decisions[k] = count.decisions();
    }
  });
  for (const DecisionCounts& d : decisions) root_decisions_ += d;
  before_.resize(root_count.size());
  tbb::parallel_for(Range(0, before_.size(), 4096), [&](const Range& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v) {
      const auto [root, above] = counts_.find(static_cast<std::uint32_t>(v));
      before_[v] = root_count[root] + above;
    }
  });
  if (observer_ != nullptr) {
    std::vector<VertexId> rayed;
    for (const std::uint32_t r : roots) rayed.push_back(clean_end(first_edge[r]).first);
    tell_counts(rayed);
  }
}

/// Of each connected part the ray first, then edge by edge the vertices that are reached from there.
void Appel::tell_counts(std::span<const VertexId> rayed) {
  std::vector<std::uint8_t> is_told(before_.size(), 0);
  for (const VertexId v : rayed) {
    observer_->rayed(v, before_[v.value]);
    is_told[v.value] = 1;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t k = 0; k < order_.size(); ++k) {
        const EdgeWalk& c = parts_[k / edges_of_block].walks[k % edges_of_block];
        const Edge& e = edge(k);
        const bool from_a = is_told[e.a.value] != 0, from_b = is_told[e.b.value] != 0;
        if (!c.is_followed() || !c.start_is_clean || !c.end_is_clean || from_a == from_b) continue;
        const VertexId to = from_a ? e.b : e.a;
        observer_->carried(requested_.edges[order_[k]], from_a ? e.a : e.b, to, before_[to.value]);
        is_told[to.value] = 1;
        goes_on = true;
      }
    }
  }
}

/// From a clean end, or else by a query of its own.
Sides Appel::start(const Part& part, std::size_t i, const Edge& e, InvisibilityCount& count) const {
  const EdgeWalk& c = part.walks[i];
  const Sides &at_start = part.at_start[i], &at_end = part.at_end[i];
  if (c.start_is_clean) {
    const std::int32_t before = before_[e.a.value];
    return {before + at_start.left, before + at_start.right};
  }
  if (c.end_is_clean) {
    const std::int32_t before = before_[e.b.value];
    return {before + at_end.left - c.left, before + at_end.right - c.right};
  }
  return {count.before(e.a, e.b, Sign::positive, occluders_) + at_start.left,
          count.before(e.a, e.b, Sign::negative, occluders_) + at_start.right};
}

/// The parts of the edge that have a triangle in front of them, just to the left or just to the right.
void Appel::add_shadows(TriangleOcclusion& occlusion, std::span<const InvisibilityChange> changes, Sides layers,
                        std::vector<HiddenInterval>& hidden) const {
  struct Place {
    Breakpoint at;
    const InvisibilityChange* change;
  };
  std::vector<Place> places;
  places.reserve(changes.size());
  for (const InvisibilityChange& c : changes) {
    const Edge& e = projected_.mesh().edges[EdgeId(c.is_face ? 0U : c.by)];
    const Cut cut = c.is_face ? Cut{Cut::Kind::face, 0, c.by, 0} : Cut{Cut::Kind::sight, 0, e.a.value, e.b.value};
    places.push_back({occlusion.place(cut), &c});
  }
  std::sort(places.begin(), places.end(),
            [&](const Place& x, const Place& y) { return occlusion.order(x.at, y.at) == Sign::negative; });
  Breakpoint from = occlusion.first();
  for (std::size_t k = 0; k <= places.size(); ++k) {
    const Breakpoint& to = k < places.size() ? places[k].at : occlusion.last();
    const bool is_hidden = layers.left > 0 || layers.right > 0;
    // Places that coincide have no length between them.
    const bool has_length = k == 0 || k == places.size() || occlusion.order(from, to) != Sign::zero;
    if (is_hidden && has_length) hidden.push_back({from, to, {}});
    if (k == places.size()) break;
    layers.left += places[k].change->left;
    layers.right += places[k].change->right;
    if (observer_ != nullptr) observer_->changed(places[k].at, *places[k].change, {layers.left, layers.right});
    from = to;
  }
}

VisibleLines Appel::tiled(const Part& part, std::size_t begin, std::size_t end) const {
  HiddenIntervals intervals(projected_, options_, observer_);
  InvisibilityCount count(projected_, layers_);
  std::vector<HiddenInterval> hidden;
  for (std::size_t k = begin; k < end; ++k) {
    const std::size_t i = k - begin;
    const EdgeId id = requested_.edges[order_[k]];
    const RequestedPart line = requested_[order_[k]];
    const ImageBox& box = requested_.boxes[order_[k]];
    const EdgeWalk& walk = part.walks[i];
    if (walk.is_hidden) {
      intervals.add_whole(line, true);
      continue;
    }
    if (walk.is_degenerate) {
      intervals.add_by_casting(line, box, occluders_);
      continue;
    }
    if (walk.is_point) {
      intervals.add_nothing(line);
      continue;
    }
    const Sides layers = start(part, i, projected_.mesh().edges[id], count);
    const std::span<const InvisibilityChange> changes(part.changes.data() + part.first_change[i],
                                                      part.changes.data() + part.first_change[i + 1]);
    if (observer_ != nullptr) {
      const CountStart from = walk.start_is_clean ? CountStart::first_vertex
                              : walk.end_is_clean ? CountStart::last_vertex
                                                  : CountStart::own_ray;
      observer_->walk_began(line, from, {layers.left, layers.right});
    }
    const bool starts_hidden = layers.left > 0 || layers.right > 0;
    if (changes.empty() && (starts_hidden || layers_.cast().empty())) {
      intervals.add_whole(line, starts_hidden);
      continue;
    }
    TriangleOcclusion& occlusion = intervals.occlusion();
    occlusion.start(id);
    hidden.clear();
    add_shadows(occlusion, changes, layers, hidden);
    layers_.cast_tree().visit(box, [&](std::uint32_t t) {
      ++intervals.pairs();
      const std::size_t before = hidden.size();
      occlusion.cast(layers_.cast()[t], hidden);
      if (observer_ != nullptr) observer_->cast(layers_.cast()[t], std::span(hidden).subspan(before));
      return true;
    });
    intervals.add(line, hidden);
  }
  VisibleLines lines = intervals.take();
  lines.decisions += count.decisions();
  return lines;
}

}  // namespace

VisibleLines appel(const ProjectedMesh& projected, const ClassifiedEdges& requested, const OccludingEdges& layers,
                   const Occluders& occluders, const LineOptions& options, CountObserver* observer) {
  return Appel(projected, requested, layers, occluders, options, observer).lines();
}

}  // namespace hsr::internal
