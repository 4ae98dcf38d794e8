#include "hsr/lines/behind_caps.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/bounded_point.h"
#include "geometry/vector3.h"
#include "hsr/lines/hidden_intervals.h"

namespace hsr::internal {

namespace {

/// Finds what caps hide of one line after the other. One object for each block of lines.
class CapShadows {
 public:
  CapShadows(const ProjectedMesh& projected, const SectionCaps& caps, const LineOptions& options, const VisibleLines& lines)
      : projected_(projected), caps_(caps), lines_(lines), intervals_(projected, options) {}

  /// Tiles the line anew; false: no cap hides any of it.
  bool add(const Line& line) {
    if (line.intervals() == 0 || (line.intervals() == 1 && line.starts_hidden)) return false;
    line_ = &line;
    TriangleOcclusion& occlusion = intervals_.occlusion();
    const auto cuts = lines_.cuts_of(line);
    const bool is_edge = !line.is_intersection();
    if (is_edge ? !occlusion.start(line.edge, cuts.front(), cuts.back())
                : !occlusion.start(lines_.intersections[line.intersection]))
      return false;
    if (!find_touching()) return false;
    find_crossings();
    hidden_.clear();
    bool hides = false;
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      const Breakpoint from = place(cuts, k), to = place(cuts, k + 1);
      if (line.hidden(k))
        hidden_.push_back({from, to, {}});
      else
        hides = hide_within(from, to) || hides;
    }
    if (!hides) return false;
    intervals_.add(LineTask(line, cuts.front(), cuts.back()), hidden_);
    return true;
  }
  VisibleLines take() { return intervals_.take(); }

 private:
  Breakpoint place(std::span<const Cut> cuts, std::size_t k) {
    TriangleOcclusion& occlusion = intervals_.occlusion();
    return k == 0 ? occlusion.first() : k + 1 == cuts.size() ? occlusion.last() : occlusion.place(cuts[k]);
  }

  /// The sides whose box in the plane touches that of the line; false: there is none, and no cap around it.
  bool find_touching() {
    touching_.clear();
    const auto from = seen_end(0), to = seen_end(1);
    caps_.visit_sides(from, to, [&](std::uint32_t side) { touching_.push_back(side); });
    return !touching_.empty() || caps_.covers(from).value_or(true);
  }
  /// The first or the last end, in the plane.
  SectionCaps::Place seen_end(std::size_t which) {
    const auto cuts = lines_.cuts_of(*line_);
    const Cut& cut = which == 0 ? cuts.front() : cuts.back();
    const auto bounded = [](const Point3& p, double error) {
      return std::array<ErrorBounded, 3>{{{p.x, error}, {p.y, error}, {p.z, error}}};
    };
    if (!line_->is_intersection()) {
      const Edge& e = projected_.mesh().edges[line_->edge];
      if (cut.kind == Cut::Kind::start || cut.kind == Cut::Kind::end)
        return caps_.seen_at(bounded(projected_.mesh().points[cut.kind == Cut::Kind::start ? e.a : e.b], 0));
      const Breakpoint& at = which == 0 ? intervals_.occlusion().first() : intervals_.occlusion().last();
      const BoundedPoint3 p = between(projected_.mesh().points[e.a], projected_.mesh().points[e.b], {at.t, at.error});
      if (p.error < HUGE_VAL) return caps_.seen_at(bounded(p.p, p.error));
    }
    const RationalVector at = exact(cut);
    const Point3 rounded = {at[0].to_double(), at[1].to_double(), at[2].to_double()};
    return caps_.seen_at(bounded(rounded, ErrorBounded::u * norm_max(rounded) + 0x1p-1070));
  }
  /// In the coordinates given.
  RationalVector exact(const Cut& cut) const {
    return exact_point(projected_.mesh(), caps_.view(), supporting_line_of(projected_.mesh(), lines_, *line_), cut);
  }

  void find_crossings() {
    TriangleOcclusion& occlusion = intervals_.occlusion();
    crossings_.clear();
    for (const std::uint32_t k : touching_) {
      if (has_edge(caps_.sides()[k].triangle)) continue;
      if (const auto at = occlusion.crossing({Cut::Kind::near_line, 0, caps_.sides()[k].triangle.value, 0}))
        crossings_.push_back(*at);
    }
    std::stable_sort(crossings_.begin(), crossings_.end(),
                     [&](const Breakpoint& x, const Breakpoint& y) { return occlusion.order(x, y) == Sign::negative; });
  }

  /// An edge of the triangle meets the plane where the side ends, and no line through that place elsewhere.
  bool has_edge(TriangleId t) const {
    if (line_->is_intersection() || projected_.facing(t) == Sign::zero) return false;
    const Edge& e = projected_.mesh().edges[line_->edge];
    return projected_.mesh().has_corner(t, e.a) && projected_.mesh().has_corner(t, e.b);
  }

  /// Between two crossings a line is behind a cap all along, or nowhere.
  bool hide_within(const Breakpoint& from, const Breakpoint& to) {
    TriangleOcclusion& occlusion = intervals_.occlusion();
    bool hides = false;
    Breakpoint last = from;
    const auto end_at = [&](const Breakpoint& here) {
      if (covers_between(last, here)) {
        hidden_.push_back({last, here, {}});
        hides = true;
      }
      last = here;
    };
    for (const Breakpoint& here : crossings_)
      if (occlusion.order(last, here) == Sign::negative && occlusion.order(here, to) == Sign::negative) end_at(here);
    end_at(to);
    return hides;
  }

  bool covers_between(const Breakpoint& from, const Breakpoint& to) {
    // Any parameter between the two will do; not half way, where models are symmetric.
    const double low = from.t + from.error, high = to.t - to.error, t = low + 0.4863 * (high - low);
    const Mesh& mesh = projected_.mesh();
    if (!line_->is_intersection() && low < t && t < high) {
      const Edge& e = mesh.edges[line_->edge];
      const Point3 &a = mesh.points[e.a], &b = mesh.points[e.b];
      const BoundedPoint3 p = between(a, b, {t, 0});
      const auto known = caps_.covers(caps_.seen_at({{{p.p.x, p.error}, {p.p.y, p.error}, {p.p.z, p.error}}}));
      if (known) return *known;
      RationalVector at = rational(a);
      const RationalVector along = minus(rational(b), at);
      for (std::size_t k = 0; k < 3; ++k) at[k] = at[k] + Rational(t) * along[k];
      return caps_.covers(caps_.seen_at(at));
    }
    const RationalVector p = exact(from.cut), q = exact(to.cut);
    RationalVector middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (p[k] + q[k]) * Rational(0.5);
    return caps_.covers(caps_.seen_at(middle));
  }

  const ProjectedMesh& projected_;
  const SectionCaps& caps_;
  const VisibleLines& lines_;
  HiddenIntervals intervals_;
  const Line* line_ = nullptr;
  std::vector<std::uint32_t> touching_;
  std::vector<Breakpoint> crossings_;
  std::vector<HiddenInterval> hidden_;
};

}  // namespace

VisibleLines behind_caps(const ProjectedMesh& projected, const SectionCaps& caps, const LineOptions& options,
                         VisibleLines lines) {
  if (caps.sides().empty()) return lines;
  constexpr std::size_t block = 256;
  constexpr std::uint32_t as_it_was = 0xffffffffU;
  std::vector<VisibleLines> parts((lines.lines.size() + block - 1) / block);
  std::vector<std::uint32_t> place(lines.lines.size(), as_it_was);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      CapShadows shadows(projected, caps, options, lines);
      std::uint32_t found = 0;
      for (std::size_t i = part * block; i < std::min(lines.lines.size(), (part + 1) * block); ++i)
        if (shadows.add(lines.lines[i])) place[i] = found++;
      parts[part] = shadows.take();
    }
  });
  VisibleLines all;
  all.intersections = std::move(lines.intersections);
  all.plan = std::move(lines.plan);
  all.pairs = lines.pairs;
  all.decisions = lines.decisions;
  for (const VisibleLines& part : parts) all.decisions += part.decisions;
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    const VisibleLines& from = place[i] == as_it_was ? lines : parts[i / block];
    const Line& found = place[i] == as_it_was ? lines.lines[i] : from.lines[place[i]];
    Line line = lines.lines[i];
    line.starts_hidden = found.starts_hidden;
    line.first_occluder = line.end_occluder = 0;
    line.first_cut = static_cast<std::uint32_t>(all.cuts.size());
    const auto cuts = from.cuts_of(found);
    all.cuts.insert(all.cuts.end(), cuts.begin(), cuts.end());
    line.end_cut = static_cast<std::uint32_t>(all.cuts.size());
    all.lines.push_back(line);
  }
  return all;
}

}  // namespace hsr::internal
