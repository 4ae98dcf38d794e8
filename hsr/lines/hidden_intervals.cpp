#include "hsr/lines/hidden_intervals.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geometry/bounded_point.h"
#include "geometry/error.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_progress.h"
#include "hsr/lines/shadow_observer.h"

namespace hsr::internal {

/// Property (1) of the result, where the build checks its invariants.
void HiddenIntervals::check_ascending([[maybe_unused]] std::span<const HiddenInterval> hidden) {
#ifdef HSR_CHECKS
  if (projected_.arithmetic() == Arithmetic::double_only) return;  // it promises nothing
  const DecisionCounts before = exact().counts();                  // the report is the same in every build
  const Breakpoint* reached = &occlusion_.first();
  for (const HiddenInterval& s : hidden) {
    const Sign gap = occlusion_.order(*reached, s.from);
    if (gap == Sign::positive || (gap == Sign::zero && &s != hidden.data()) || occlusion_.order(s.from, s.to) != Sign::negative)
      throw InvariantError("roberts: hidden intervals that are empty, touch or overlap");
    reached = &s.to;
  }
  if (occlusion_.order(*reached, occlusion_.last()) == Sign::positive)
    throw InvariantError("roberts: a hidden interval beyond the end of its edge");
  exact().counts() = before;
#endif
}

/// Greedy: of the faces whose shadow covers the start, the one that reaches furthest, the lowest index first. One sweep over
/// the shadows of the faces, which ascend by their start, then by face.
void HiddenIntervals::name_occluders(std::span<const HiddenInterval> hidden, std::span<const HiddenInterval> by_face) {
  std::size_t next = 0;
  const HiddenInterval* furthest = nullptr;
  for (const HiddenInterval& interval : hidden) {
    Breakpoint reached = interval.from;
    while (occlusion_.order(reached, interval.to) == Sign::negative) {
      for (; next < by_face.size() && occlusion_.order(by_face[next].from, reached) != Sign::positive; ++next) {
        const HiddenInterval& s = by_face[next];
        const Sign further = furthest == nullptr ? Sign::negative : occlusion_.order(furthest->to, s.to);
        if (further == Sign::negative || (further == Sign::zero && s.face < furthest->face)) furthest = &s;
      }
      if (furthest == nullptr || occlusion_.order(reached, furthest->to) != Sign::negative)
        throw InvariantError("roberts: a hidden interval without an occluder");
      result_.occluders.push_back({furthest->face, furthest->from.cut, furthest->to.cut});
      reached = furthest->to;
    }
  }
}

void HiddenIntervals::sort_by_face() {
  by_face_.clear();
  std::stable_sort(cast_.begin(), cast_.end(),
                   [](const HiddenInterval& x, const HiddenInterval& y) { return x.face < y.face; });
  for (auto i = cast_.begin(); i != cast_.end();) {
    const auto end = std::find_if(i, cast_.end(), [&](const HiddenInterval& s) { return s.face != i->face; });
    one_face_.assign(i, end);
    unite(occlusion_, one_face_);
    by_face_.insert(by_face_.end(), one_face_.begin(), one_face_.end());
    i = end;
  }
  std::stable_sort(by_face_.begin(), by_face_.end(), [&](const HiddenInterval& x, const HiddenInterval& y) {
    return occlusion_.order(x.from, y.from) == Sign::negative;
  });
}

Line HiddenIntervals::begun(const LineTask& tiled) const {
  Line line;
  line.edge = tiled.edge;
  line.intersection = tiled.intersection;
  line.edge_class = tiled.edge_class;
  line.is_behind = tiled.is_behind;
  line.first_cut = static_cast<std::uint32_t>(result_.cuts.size());
  line.first_occluder = static_cast<std::uint32_t>(result_.occluders.size());
  return line;
}

void HiddenIntervals::end(Line line) {
  check_countable(std::max(result_.cuts.size(), result_.occluders.size()), "interval ends of neighbouring edges");
  line.end_cut = static_cast<std::uint32_t>(result_.cuts.size());
  line.end_occluder = static_cast<std::uint32_t>(result_.occluders.size());
  result_.lines.push_back(line);
  if (observer_ != nullptr) observer_->ended(line, result_.cuts_of(line));
}

void HiddenIntervals::add_nothing(const LineTask& tiled) { end(begun(tiled)); }

void HiddenIntervals::add_whole(const LineTask& tiled, bool is_hidden) {
  Line line = begun(tiled);
  line.starts_hidden = is_hidden;
  result_.cuts.push_back(tiled.from);
  result_.cuts.push_back(tiled.to);
  end(line);
}

void HiddenIntervals::add(const LineTask& tiled, std::vector<HiddenInterval>& cast) {
  if (observer_ == nullptr)
    unite(occlusion_, cast);
  else
    unite(occlusion_, cast, *observer_);
  check_ascending(cast);
  Line line = begun(tiled);
  if (options_.why) name_occluders(cast, by_face_);
  auto& cuts = result_.cuts;
  cuts.push_back(occlusion_.first().cut);
  line.starts_hidden = !cast.empty() && occlusion_.order(occlusion_.first(), cast.front().from) == Sign::zero;
  for (const HiddenInterval& s : cast) {
    if (&s != &cast.front() || !line.starts_hidden) cuts.push_back(s.from.cut);
    cuts.push_back(s.to.cut);
  }
  if (cast.empty() || occlusion_.order(cast.back().to, occlusion_.last()) != Sign::zero) cuts.push_back(occlusion_.last().cut);
  end(line);
}

void HiddenIntervals::add_by_casting(const RequestedPart& part, const ImageBox& box, const Occluders& occluders,
                                     const OcclusionPyramid* pyramid) {
  if (!occlusion_.start(part.edge, part.from, part.to)) {
    add_nothing(part);
    return;
  }
  const bool is_whole = part.from.kind == Cut::Kind::start && part.to.kind == Cut::Kind::end;
  if (pyramid == nullptr || options_.why || !is_whole || !cast_unhidden(part, occluders, *pyramid))
    cast_all(part, box, occluders);
}

void HiddenIntervals::add_by_casting(std::uint32_t i, const Intersection& meet, const ImageBox& box,
                                     const Occluders& occluders) {
  const LineTask line(i, meet);
  if (occlusion_.start(meet))
    cast_all(line, box, occluders);
  else
    add_nothing(line);
}

/// Whether the shadow covers certainly all of the stretch.
bool HiddenIntervals::covers(const HiddenInterval& s, const Stretch& stretch) const {
  return (s.from.cut == occlusion_.first().cut || s.from.t + s.from.error < stretch.from - stretch.error) &&
         (s.to.cut == occlusion_.last().cut || s.to.t - s.to.error > stretch.to + stretch.error);
}

/// Appends the shadows on a stretch of the line, or some that cover it.
void HiddenIntervals::cast_on(const Stretch& stretch, const ImageBox& box, const Occluders& occluders) {
  std::size_t united = cast_.size();  // when they were last united
  const auto one_covers = [&](std::size_t begin) {
    return std::any_of(cast_.begin() + static_cast<std::ptrdiff_t>(begin), cast_.end(),
                       [&](const HiddenInterval& s) { return covers(s, stretch); });
  };
  occluders.tree.visit_boxes<BoxTree::Depth::hiding>(box, [&](std::uint32_t i, std::uint32_t at) {
    ++result_.pairs;
    const std::size_t before = cast_.size();
    if (!occluders.is_prepared())
      occlusion_.cast(occluders.triangles[i], cast_);
    else
      occlusion_.cast(occluders.faces()[at], cast_);
    if (options_.why || cast_.size() == before) return true;
    if (one_covers(before)) return false;
    // Now and then the shadows so far are united: together they may hide all of it. As their number doubles, so that a long
    // edge behind many separate faces costs no more than sorting them a few times.
    if (cast_.size() < 2 * united + 4) return true;
    unite(occlusion_, cast_);
    united = cast_.size();
    return !one_covers(0);
  });
}

/// The same along all of the line, each shadow told.
void HiddenIntervals::cast_watched(const ImageBox& box, const Occluders& occluders) {
  occluders.tree.visit_boxes<BoxTree::Depth::hiding>(box, [&](std::uint32_t i, std::uint32_t /*at*/) {
    ++result_.pairs;
    const std::size_t before = cast_.size();
    occlusion_.cast(occluders.triangles[i], cast_);
    observer_->cast(occluders.triangles[i], std::span(cast_).subspan(before));
    return true;
  });
}

void HiddenIntervals::cast_all(const LineTask& line, const ImageBox& box, const Occluders& occluders) {
  cast_.clear();
  if (observer_ == nullptr) {
    cast_on({-HUGE_VAL, HUGE_VAL}, box, occluders);
  } else {
    observer_->began(line, occlusion_.first(), occlusion_.last());
    cast_watched(box, occluders);
  }
  if (options_.why) sort_by_face();
  add(line, cast_);
}

/// In perspective a share s of the way along the image is t = s m / (n + s (m - n)) along the edge, m and n the nearness of its
/// ends, which is minus their depth. @pre shares from 0 to 1, or infinite
HiddenIntervals::Stretch HiddenIntervals::stretch(const Edge& edge, double from_share, double to_share) const {
  if (!projected_.is_perspective()) return {from_share, to_share};
  const ErrorBounded m = projected_.nearness(projected_.point(edge.a), 0), n = projected_.nearness(projected_.point(edge.b), 0);
  const auto t = [&](double share) {
    if (std::isinf(share)) return ErrorBounded{share, 0};
    const ErrorBounded s{share, 0};
    return quotient(s * m, n + s * (m - n));
  };
  const ErrorBounded from = t(from_share), to = t(to_share);
  return {from.value, to.value, std::max(from.error, to.error)};
}

/// Around a stretch of an edge.
ImageBox HiddenIntervals::box_of(const Edge& edge, const Stretch& stretch) const {
  const auto box_at = [&](double t) {
    if (t <= 0) return projected_.box(edge.a);
    if (t >= 1) return projected_.box(edge.b);
    const BoundedPoint3 at = between(projected_.point(edge.a), projected_.point(edge.b), {t, stretch.error});
    return projected_.box(at.p, 3 * at.error);
  };
  ImageBox box = box_at(stretch.from);
  box.add(box_at(stretch.to));
  return box;
}

/// Looks only along what the tiles do not hide. False: nothing is known, or not for certain.
bool HiddenIntervals::cast_unhidden(const LineTask& line, const Occluders& occluders, const OcclusionPyramid& pyramid) {
  const Edge& edge = projected_.mesh().edges[line.edge];
  if (!pyramid.unhidden(edge, unhidden_)) return false;
  if (unhidden_.empty()) {
    add_whole(line, true);
    return true;
  }
  cast_.clear();
  unhidden_stretches_.clear();
  looked_at_.clear();
  for (const UnhiddenInterval& part : unhidden_) {
    unhidden_stretches_.push_back(stretch(edge, part.from, part.to));
    looked_at_.push_back(stretch(edge, part.low, part.high));
    if (!(looked_at_.back().error < HUGE_VAL)) return false;
    ImageBox around = box_of(edge, looked_at_.back());
    around.farthest = std::max(around.farthest, part.hidden_from);
    cast_on(looked_at_.back(), around, occluders);
  }
  unite(occlusion_, cast_);
  if (!close_gaps()) return false;
  add(line, cast_);
  return true;
}

/// Between the shadows, which ascend, are what is visible and what was not looked at, as it is hidden: these are closed. Both
/// ends of a hidden stretch have been looked at: shadows reach some way into it. False: doubles do not tell.
bool HiddenIntervals::close_gaps() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t n = looked_at_.size();
  enum class Gap : std::uint8_t { visible, hidden, unknown };
  const auto gap = [&](const Breakpoint& from, const Breakpoint& to) {
    const double begin = from.t + from.error, end = to.t - to.error;
    for (std::size_t k = 0; k <= n; ++k) {
      const double after = k == 0 ? -infinity : unhidden_stretches_[k - 1].to + unhidden_stretches_[k - 1].error;
      const double before = k == n ? infinity : unhidden_stretches_[k].from - unhidden_stretches_[k].error;
      if (end > after && begin < before) return Gap::hidden;
      const bool begins_before = k > 0 && begin < looked_at_[k - 1].to - looked_at_[k - 1].error;
      const bool ends_after = k < n && end > looked_at_[k].from + looked_at_[k].error;
      if (!begins_before && !ends_after) return Gap::unknown;
    }
    return Gap::visible;
  };
  const Breakpoint &first = occlusion_.first(), &last = occlusion_.last();
  if (cast_.empty()) return gap(first, last) == Gap::visible;
  // Into one what only a hidden gap parts.
  if (cast_.front().from.cut != first.cut) {
    const Gap g = gap(first, cast_.front().from);
    if (g == Gap::unknown) return false;
    if (g == Gap::hidden) cast_.front().from = first;
  }
  std::size_t kept = 0;
  for (std::size_t i = 1; i < cast_.size(); ++i) {
    const Gap g = gap(cast_[kept].to, cast_[i].from);
    if (g == Gap::unknown) return false;
    if (g == Gap::hidden)
      cast_[kept].to = cast_[i].to;
    else
      cast_[++kept] = cast_[i];
  }
  cast_.resize(kept + 1);
  if (cast_.back().to.cut != last.cut) {
    const Gap g = gap(cast_.back().to, last);
    if (g == Gap::unknown) return false;
    if (g == Gap::hidden) cast_.back().to = last;
  }
  return true;
}

VisibleLines intervals_in_blocks(const ProjectedMesh& projected, const LineOptions& options,
                                 std::span<const std::uint32_t> order,
                                 const std::function<void(HiddenIntervals&, std::uint32_t)>& add, ShadowObserver* observer) {
  std::vector<VisibleLines> parts((order.size() + edges_of_block - 1) / edges_of_block);
  std::vector<std::array<std::uint32_t, 2>> place(order.size());
  LineProgress progress(options.progress, options.stop, order.size());
  using Range = tbb::blocked_range<std::size_t>;
  const auto find = [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      HiddenIntervals intervals(projected, options, observer);
      const std::size_t begin = part * edges_of_block, end = std::min(begin + edges_of_block, order.size());
      for (std::size_t k = begin; k < end; ++k) {
        place[order[k]] = {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k - begin)};
        add(intervals, order[k]);
      }
      parts[part] = intervals.take();
      progress.advance(end - begin);
    }
  };
  if (observer == nullptr)
    tbb::parallel_for(Range(0, parts.size(), 1), find);
  else
    find(Range(0, parts.size(), 1));
  return joined(parts, place);
}

VisibleLines joined(const std::vector<VisibleLines>& parts, const std::vector<std::array<std::uint32_t, 2>>& place) {
  VisibleLines all;
  for (const VisibleLines& part : parts) {
    all.pairs += part.pairs;
    all.decisions += part.decisions;
  }
  std::size_t cuts = 0, occluders = 0;
  for (const VisibleLines& part : parts) {
    cuts += part.cuts.size();
    occluders += part.occluders.size();
  }
  const std::size_t most = std::max(cuts, occluders);
  if (most > 0xffffffffU)
    throw InputError("the drawing has " + std::to_string(most) + " interval ends, expected fewer than 2^32");
  // To touch new memory for the first time takes longer than to fill it.
  tbb::parallel_invoke([&] { all.lines.resize(place.size()); }, [&] { all.cuts.resize(cuts); },
                       [&] { all.occluders.resize(occluders); });
  // Where the cuts and occluders of each block of lines go.
  struct Start {
    std::size_t cut, occluder;
  };
  constexpr std::size_t block = 4096;
  std::vector<Start> starts((place.size() + block - 1) / block);
  const auto for_each_block = [&](const auto& visit) {
    tbb::parallel_for(std::size_t{0}, starts.size(),
                      [&](std::size_t k) { visit(k, k * block, std::min(place.size(), (k + 1) * block)); });
  };
  for_each_block([&](std::size_t k, std::size_t begin, std::size_t end) {
    Start sum = {0, 0};
    for (std::size_t i = begin; i < end; ++i) {
      const Line& line = all.lines[i] = parts[place[i][0]].lines[place[i][1]];
      sum.cut += line.end_cut - line.first_cut;
      sum.occluder += line.end_occluder - line.first_occluder;
    }
    starts[k] = sum;
  });
  Start next = {0, 0};
  for (Start& start : starts) {
    const Start sum = std::exchange(start, next);
    next = {next.cut + sum.cut, next.occluder + sum.occluder};
  }
  for_each_block([&](std::size_t k, std::size_t begin, std::size_t end) {
    auto cut = all.cuts.begin() + static_cast<std::ptrdiff_t>(starts[k].cut);
    auto occluder = all.occluders.begin() + static_cast<std::ptrdiff_t>(starts[k].occluder);
    for (std::size_t i = begin; i < end; ++i) {
      Line& line = all.lines[i];
      const VisibleLines& part = parts[place[i][0]];
      const auto its_cuts = part.cuts_of(line);
      const auto its_occluders = part.occluders_of(line);
      line.first_cut = static_cast<std::uint32_t>(cut - all.cuts.begin());
      line.first_occluder = static_cast<std::uint32_t>(occluder - all.occluders.begin());
      cut = std::copy(its_cuts.begin(), its_cuts.end(), cut);
      occluder = std::copy(its_occluders.begin(), its_occluders.end(), occluder);
      line.end_cut = static_cast<std::uint32_t>(cut - all.cuts.begin());
      line.end_occluder = static_cast<std::uint32_t>(occluder - all.occluders.begin());
    }
  });
  return all;
}

}  // namespace hsr::internal
