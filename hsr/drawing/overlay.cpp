#include "hsr/drawing/overlay.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace hsr::internal {

namespace {

/// Of coinciding lines the one of lower rank is drawn.
int precedence(EdgeClass edge_class) {
  switch (edge_class) {
    case EdgeClass::outline:
      return 0;
    case EdgeClass::boundary:
      return 1;
    case EdgeClass::sharp:
      return 2;
    case EdgeClass::intersection:
      return 3;
    case EdgeClass::material:
      return 4;
    case EdgeClass::overhead:
      return 5;
    case EdgeClass::wire:
      return 6;
    case EdgeClass::joint:
      return 7;
    case EdgeClass::smooth:
    case EdgeClass::section:
    case EdgeClass::hatching:
      break;  // the last two are no lines of the scene
  }
  return 8;
}

}  // namespace

void Overlay::append(const Overlay& other) {
  check_countable(sources.size() + other.sources.size(), "edges along lines");
  const auto shift = static_cast<std::uint32_t>(sources.size());
  sources.insert(sources.end(), other.sources.begin(), other.sources.end());
  for (Stroke s : other.strokes) {
    s.first_source += shift;
    s.end_source += shift;
    strokes.push_back(s);
  }
  visible_under_visible += other.visible_under_visible;
  hidden_under_visible += other.hidden_under_visible;
  hidden_under_hidden += other.hidden_under_hidden;
  merged += other.merged;
}

void LineOverlay::add_single(std::uint32_t line, Overlay& result) const {
  const Line& l = lines_.lines[line];
  for (std::uint32_t k = 0; k < l.intervals(); ++k) {
    if (l.hidden(k) && !with_hidden_) continue;
    const auto source = static_cast<std::uint32_t>(result.sources.size());
    result.sources.push_back(line);
    result.strokes.push_back(
        {{line, l.first_cut + k}, {line, l.first_cut + k + 1}, l.hidden(k), l.edge_class, source, source + 1, object_of(line)});
  }
}

void LineOverlay::add_group(std::span<const std::uint32_t> group, bool steep, Overlay& result) {
  steep_ = steep;
  const auto edge = std::find_if(group.begin(), group.end(), [&](auto i) { return !lines_.lines[i].is_intersection(); });
  const SupportingLine support = edge == group.end() ? SupportingLine() : supporting_line_of(*edge);
  a_ = support.a;
  b_ = support.b;
  axis_ = -1;
  collect(group);
  if (parts_.empty()) return;
  rank();
  lay(result);
}

void LineOverlay::collect(std::span<const std::uint32_t> group) {
  positions_.clear();
  parts_.clear();
  for (const std::uint32_t line : group) {
    const Line& l = lines_.lines[line];
    std::uint32_t last = 0xffffffffU;  // the cut that the last position is
    const auto position = [&](std::uint32_t cut) {
      if (cut != last) {
        Position p;
        p.place = {line, cut};
        const HomogeneousPoint h = projection_.at(supporting_line_of(line), lines_.cuts[cut]);
        p.coordinate = (steep_ ? h.y : h.x) / h.w;
        positions_.push_back(std::move(p));
        last = cut;
      }
      return static_cast<std::uint32_t>(positions_.size() - 1);
    };
    for (std::uint32_t k = 0; k < l.intervals(); ++k) {
      if (l.hidden(k) && !with_hidden_) continue;
      const std::uint32_t from = position(l.first_cut + k), to = position(l.first_cut + k + 1);
      parts_.push_back({from, to, line, l.hidden(k), l.edge_class});
    }
  }
}

VertexId LineOverlay::vertex_at(Position& p) {
  if (p.vertex_is_known) return p.vertex;
  p.vertex_is_known = true;
  const Cut& cut = cut_of(p.place);
  const SupportingLine edge = supporting_line_of(p.place.line);
  const Mesh& mesh = projection_.mesh();
  const View& view = projection_.view();
  if (cut.kind == Cut::Kind::start) p.vertex = edge.a;
  if (cut.kind == Cut::Kind::end) p.vertex = edge.b;
  // A cut by the view plane of u v, or by the line of sight of u, is at the image of u if u is on this line of the image.
  const auto is_here = [&](VertexId u) {
    if (!a_.is_valid()) return false;
    if (!projection_.at(u).w.is_positive()) return false;  // behind the eye it would be seen the other way
    return predicates_.side(Plane::of_sight(view.viewpoint, mesh.points[a_], mesh.points[b_]), mesh.points[u]) == Sign::zero;
  };
  if (cut.kind == Cut::Kind::sight || cut.kind == Cut::Kind::sight_of_vertex) {
    const VertexId u(cut.u), v(cut.v);
    if (is_here(u))
      p.vertex = u;
    else if (cut.kind == Cut::Kind::sight && is_here(v))
      p.vertex = v;
  }
  return p.vertex;
}

// With an axis out of this line's view plane, the planes through the viewpoint and parallel to the axis cut the line once each.
bool LineOverlay::at_one_place(VertexId v, VertexId w) {
  if (v == w) return true;
  const Mesh& mesh = projection_.mesh();
  const Viewpoint& e = projection_.view().viewpoint;
  if (axis_ < 0) {
    axis_ = 0;
    while (axis_ < 3 && predicates_.side(Plane::of_sight_along_axis(e, mesh.points[a_], axis_), mesh.points[b_]) == Sign::zero)
      ++axis_;
  }
  if (axis_ == 3) return false;  // no view plane contains all three axes: inexact arithmetic says so. Rationals answer instead
  return predicates_.side(Plane::of_sight_along_axis(e, mesh.points[v], axis_), mesh.points[w]) == Sign::zero;
}

const Rational& LineOverlay::exact_coordinate(Position& p) {
  if (!p.exact) p.exact = projection_.exact(supporting_line_of(p.place.line), cut_of(p.place))[steep_ ? 1 : 0];
  return *p.exact;
}

int LineOverlay::compare(std::uint32_t i, std::uint32_t j) {
  Position &p = positions_[i], &q = positions_[j];
  if (certainly_less(p.coordinate, q.coordinate)) return -1;
  if (certainly_less(q.coordinate, p.coordinate)) return 1;
  if (i == j) return 0;
  const VertexId v = vertex_at(p), w = vertex_at(q);
  if (v.is_valid() && w.is_valid() && at_one_place(v, w)) return 0;
  const Cut &c = cut_of(p.place), &d = cut_of(q.place);
  if (c.kind == Cut::Kind::sight && d.kind == Cut::Kind::sight && std::minmax(c.u, c.v) == std::minmax(d.u, d.v)) return 0;
  if (c.kind == Cut::Kind::near_line && d.kind == Cut::Kind::near_line && c.u == d.u && c.axis == d.axis) return 0;
  const auto order = exact_coordinate(p) <=> exact_coordinate(q);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

void LineOverlay::rank() {
  std::vector<std::uint32_t> order(positions_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return compare(i, j) < 0; });
  place_of_rank_.clear();
  // Of the places at one point the cheapest to round speaks for all: an end of an edge; then the first.
  const auto key = [&](std::uint32_t i) {
    const Cut::Kind kind = cut_of(positions_[i].place).kind;
    return std::make_pair(kind != Cut::Kind::start && kind != Cut::Kind::end, i);
  };
  std::uint32_t best = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || compare(order[k - 1], order[k]) != 0;
    if (is_new) place_of_rank_.emplace_back();
    if (is_new || key(order[k]) < key(best)) best = order[k];
    place_of_rank_.back() = positions_[best].place;
    positions_[order[k]].rank = static_cast<std::uint32_t>(place_of_rank_.size() - 1);
  }
  for (Part& part : parts_) {
    const std::uint32_t from = positions_[part.from].rank, to = positions_[part.to].rank;
    part.from = std::min(from, to);
    part.to = std::max(from, to);
  }
}

void LineOverlay::lay(Overlay& result) {
  constexpr std::uint32_t none = 0xffffffffU;
  const std::size_t gaps = place_of_rank_.size() - 1;  // gap g lies between ranks g and g + 1
  // Order of precedence: class, then edge.
  const auto key = [](const Part& p) { return std::make_tuple(precedence(p.edge_class), p.line, p.from); };
  std::sort(parts_.begin(), parts_.end(), [&](const Part& p, const Part& q) { return key(p) < key(q); });
  std::vector<std::uint32_t> by_start(parts_.size()), by_end(parts_.size());
  std::iota(by_start.begin(), by_start.end(), 0U);
  by_end = by_start;
  std::sort(by_start.begin(), by_start.end(),
            [&](auto i, auto j) { return std::tie(parts_[i].from, i) < std::tie(parts_[j].from, j); });
  std::sort(by_end.begin(), by_end.end(),
            [&](auto i, auto j) { return std::tie(parts_[i].to, i) < std::tie(parts_[j].to, j); });

  // The part that is seen in each gap, of the visible and of the hidden ones.
  std::vector<std::uint32_t> top[2] = {std::vector<std::uint32_t>(gaps, none), std::vector<std::uint32_t>(gaps, none)};
  std::set<std::uint32_t> active[2];
  std::size_t s = 0, e = 0;
  for (std::uint32_t g = 0; g < gaps; ++g) {
    for (; e < by_end.size() && parts_[by_end[e]].to == g; ++e) active[parts_[by_end[e]].hidden].erase(by_end[e]);
    for (; s < by_start.size() && parts_[by_start[s]].from == g; ++s) active[parts_[by_start[s]].hidden].insert(by_start[s]);
    for (int hidden = 0; hidden < 2; ++hidden)
      if (!active[hidden].empty()) top[hidden][g] = *active[hidden].begin();
  }

  struct Run {
    std::uint32_t from, to;
    bool hidden;
    EdgeClass edge_class;
    std::uint32_t object;
    std::vector<std::uint32_t> sources;
  };
  std::vector<Run> runs;
  for (std::uint32_t g = 0; g < gaps; ++g) {
    const bool hidden = top[0][g] == none;
    const std::uint32_t part = top[hidden][g];
    if (part == none) continue;
    const EdgeClass c = parts_[part].edge_class;
    const std::uint32_t object = object_of(parts_[part].line);
    const bool goes_on = !runs.empty() && runs.back().to == g && runs.back().hidden == hidden && runs.back().edge_class == c &&
                         runs.back().object == object;
    if (goes_on) {
      runs.back().to = g + 1;
      if (top[hidden][g - 1] != part) ++result.merged;
    } else {
      runs.push_back({g, g + 1, hidden, c, object, {}});
    }
  }

  // Sums over the gaps before: how many show a visible part, and how often the part on top changes.
  std::vector<std::uint32_t> covered(gaps + 1, 0), changes[2] = {covered, covered};
  for (std::size_t g = 0; g < gaps; ++g) {
    covered[g + 1] = covered[g] + (top[0][g] != none ? 1U : 0U);
    for (int hidden = 0; hidden < 2; ++hidden)
      changes[hidden][g + 1] = changes[hidden][g] + (g > 0 && top[hidden][g] != top[hidden][g - 1] ? 1U : 0U);
  }
  for (std::uint32_t i = 0; i < parts_.size(); ++i) {
    const Part& p = parts_[i];
    const bool alone = top[p.hidden][p.from] == i && changes[p.hidden][p.to] == changes[p.hidden][p.from + 1];
    if (!p.hidden && !alone) ++result.visible_under_visible;
    if (p.hidden && covered[p.to] != covered[p.from]) ++result.hidden_under_visible;
    if (p.hidden && !alone) ++result.hidden_under_hidden;
    auto run =
        std::lower_bound(runs.begin(), runs.end(), p.from, [](const Run& r, std::uint32_t from) { return r.to <= from; });
    for (; run != runs.end() && run->from < p.to; ++run)
      if (run->hidden == p.hidden) run->sources.push_back(p.line);
  }
  for (Run& run : runs) {
    std::sort(run.sources.begin(), run.sources.end());
    run.sources.erase(std::unique(run.sources.begin(), run.sources.end()), run.sources.end());
    const auto first = static_cast<std::uint32_t>(result.sources.size());
    result.sources.insert(result.sources.end(), run.sources.begin(), run.sources.end());
    result.strokes.push_back({place_of_rank_[run.from], place_of_rank_[run.to], run.hidden, run.edge_class, first,
                              static_cast<std::uint32_t>(result.sources.size()), run.object});
  }
}

}  // namespace hsr::internal
