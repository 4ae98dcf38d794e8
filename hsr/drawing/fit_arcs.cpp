#include "hsr/drawing/fit_arcs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "hsr/drawing/circle_image.h"

namespace hsr::internal {

namespace {

constexpr std::size_t least_lines = 4;                     // on a circle that is not known
constexpr double most_turn = 35 * std::numbers::pi / 180;  // as of corners of dashed lines
constexpr double share_by_design = 1.0 / 100;              // of the tolerance, of vertices of circles that are no chance

/// Lines of a polyline on one circle; `end` is one past the last.
struct Run {
  std::size_t begin = 0, end = 0;
  SpaceCircle circle = {};
  bool is_ring = false;  ///< the whole of a closed polyline
  bool is_known = false;

  std::size_t fewest_lines() const { return is_known ? 1 : least_lines; }
};

Point2 in_millimetres(const PaperPoint& p) { return {static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000}; }

/// The runs of one polyline.
class RunFinder {
 public:
  RunFinder(const Mesh& mesh, const PaperMap& map, const MarkedCircles& known, double tolerance)
      : mesh_(mesh), map_(map), known_(known), tolerance_(tolerance) {}

  /// @param points on paper @param edges of the lines from each to the next
  std::vector<Run> runs(const std::vector<Point2>& points, bool closed,
                        const std::vector<std::span<const std::array<VertexId, 2>>>& edges) {
    count_ = edges.size();
    spans_.clear();
    for (std::size_t k = 0; k < count_; ++k) spans_.push_row(spans_of(edges[k], points[k], points[(k + 1) % points.size()]));
    std::vector<Run> all = known_runs(closed);
    if (!all.empty() && all[0].is_ring) return all;
    for (const double share : {share_by_design, 1.0}) {
      share_ = share;
      if (closed && all.empty())
        if (const auto ring = whole_ring()) return {*ring};
      std::vector<Run> found = all;
      std::size_t begin = 0;
      for (const Run& run : all) {
        add_runs(begin, run.begin, found);
        begin = run.end;
      }
      add_runs(begin, count_, found);
      std::ranges::sort(found, {}, &Run::begin);
      all = std::move(found);
    }
    return all;
  }

 private:
  using Span = std::array<VertexId, 2>;

  SpaceVector place(VertexId v) const { return map_.relative(mesh_.points[v]); }

  /// From which vertex to which a line may lead: each chain of its edges that runs its way.
  std::vector<Span> spans_of(std::span<const Span> edges, const Point2& from, const Point2& to) const {
    constexpr std::size_t most = 8;  // more in a row are no part of a curve
    std::vector<Span> ahead;
    if (edges.size() > most) return ahead;
    for (Span e : edges) {
      const Point2 a = map_.at(place(e[0])), b = map_.at(place(e[1]));
      if ((b.x - a.x) * (to.x - from.x) + (b.y - a.y) * (to.y - from.y) < 0) std::swap(e[0], e[1]);
      ahead.push_back(e);
    }
    std::vector<Span> spans = ahead;
    for (Span& span : spans)
      for (std::size_t steps = 0; steps < ahead.size(); ++steps) {
        const auto next = std::ranges::find(ahead, span[1], [](const Span& e) { return e[0]; });
        if (next == ahead.end()) break;
        span[1] = (*next)[1];
      }
    return spans;
  }

  /// Makes the chain of vertices from line `begin` on `lines` lines long.
  bool lengthen(std::vector<VertexId>& chain, std::size_t begin, std::size_t lines) const {
    while (chain.size() <= lines) {
      const std::size_t line = begin + chain.size() - 1;
      if (line >= count_) return false;
      const auto row = spans_[line];
      const auto next = std::ranges::find(row, chain.back(), [](const Span& s) { return s[0]; });
      if (next == row.end()) return false;
      chain.push_back((*next)[1]);
    }
    return true;
  }

  /// A circle, and whether what is on it bows out of the chord by more than the tolerance: it may be a straight line yet.
  struct Fit {
    SpaceCircle circle;
    bool is_bowed;
  };

  /// The circle that the first vertices of a chain are on, and the edges between them, if there is one.
  std::optional<Fit> circle_of(const std::vector<VertexId>& chain, std::size_t lines, bool is_ring) {
    places_.clear();
    for (std::size_t k = 0; k <= lines; ++k) places_.push_back(place(chain[k]));
    const auto circle = circle_through({places_.data(), places_.size() - (is_ring ? 1 : 0)});
    return circle ? fit_of(*circle, is_ring) : std::nullopt;
  }

  /// A circle, if places_ and the edges between them are on it.
  std::optional<Fit> fit_of(const SpaceCircle& circle, bool is_ring) const {
    double turned = 0, most = 0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const SpaceVector& p = places_[k];
      const double scale = map_.magnification(p);
      most = std::max(most, scale);
      if (!(circle.distance(p) * scale <= share_ * tolerance_)) return {};
      if (k + 1 == places_.size()) break;
      const SpaceVector& q = places_[k + 1];
      if (!(circle.distance({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}) * scale <= tolerance_)) return {};
      const double turn = std::remainder(circle.angle(q) - circle.angle(p), 2 * std::numbers::pi);
      if (!(turn > 0 && turn <= most_turn)) return {};
      turned += turn;
    }
    constexpr double all_around = 2 * std::numbers::pi;
    if (is_ring ? !(std::fabs(turned - all_around) < 0.1) : !(turned < all_around)) return {};
    const double rise = circle.radius * (1 - std::cos(std::min(turned / 2, std::numbers::pi)));
    return Fit{circle, rise * most > tolerance_};
  }

  std::optional<SpaceCircle> known_circle(const Span& s) const {
    const KnownCircle* const c = known_.of(s[0], s[1]);
    if (c == nullptr) return {};
    return circle_around(map_.relative(c->centre), {c->axis.x, c->axis.y, c->axis.z}, c->radius, place(s[0]), place(s[1]));
  }

  /// The longest run from `begin` on whose edges are known to be on one circle, or an empty one.
  Run longest_known(std::size_t begin) {
    Run best;
    for (const Span& first : spans_[begin]) {
      const auto circle = known_circle(first);
      if (!circle) continue;
      places_ = {place(first[0]), place(first[1])};
      VertexId last = first[1];
      std::size_t end = begin + 1;
      const auto goes_on = [&](const Span& s) {
        if (s[0] != last) return false;
        const auto next = known_circle(s);
        return next && are_one(*circle, *next);
      };
      for (; end < count_ && last != first[0]; ++end) {
        const auto row = spans_[end];
        const auto next = std::ranges::find_if(row, goes_on);
        if (next == row.end()) break;
        last = (*next)[1];
        places_.push_back(place(last));
      }
      const bool is_around = last == first[0];
      if (end - begin > best.end - best.begin && fit_of(*circle, is_around))
        best = {begin, end, *circle, is_around && end - begin == count_, true};
    }
    return best;
  }

  std::vector<Run> known_runs(bool closed) {
    std::vector<Run> all;
    share_ = share_by_design;
    for (std::size_t begin = 0; !known_.is_empty() && begin < count_;) {
      Run run = longest_known(begin);
      run.is_ring = run.is_ring && closed;
      if (run.end > run.begin) all.push_back(run);
      begin = std::max(run.end, begin + 1);
    }
    return all;
  }

  std::optional<Run> whole_ring() {
    for (const Span& first : spans_[0]) {
      std::vector<VertexId> chain = {first[0], first[1]};
      if (count_ < least_lines || !lengthen(chain, 0, count_) || chain.back() != chain.front()) continue;
      if (const auto fit = circle_of(chain, count_, true); fit && fit->is_bowed) return Run{0, count_, fit->circle, true};
    }
    return {};
  }

  /// The longest run from `begin` on, or an empty one: twice as far each time, then by halves.
  Run longest(std::size_t begin, std::size_t end) {
    Run best;
    for (const Span& first : spans_[begin]) {
      std::vector<VertexId> chain = {first[0], first[1]};
      std::size_t step = least_lines, lines = 0;
      while (step > 0) {
        const std::size_t wanted = std::min(lines + step, end - begin);
        std::optional<Fit> fit;
        if (wanted >= least_lines && wanted > lines && lengthen(chain, begin, wanted)) fit = circle_of(chain, wanted, false);
        if (fit) {
          lines = wanted;
          step *= 2;
          if (fit->is_bowed && lines > best.end - best.begin) best = {begin, begin + lines, fit->circle, false};
        } else {
          step = lines == 0 ? 0 : step / 2;
        }
      }
    }
    return best;
  }

  void add_runs(std::size_t begin, std::size_t end, std::vector<Run>& found) {
    while (begin + least_lines <= end) {
      const Run run = longest(begin, end);
      if (run.end > run.begin) found.push_back(run);
      begin = std::max(run.end, begin + 1);
    }
  }

  const Mesh& mesh_;
  const PaperMap& map_;
  const MarkedCircles& known_;
  double tolerance_, share_ = 1;
  std::size_t count_ = 0;
  Ragged<Span> spans_;
  std::vector<SpaceVector> places_;
};

/// What an arc that does not pass through the ends of its run becomes.
enum class Ends { must_be_on_it, move_it };

/// A run as an arc on paper.
std::optional<DrawnArc> arc_of(const EllipseArc& ellipse, std::span<const Point2> run, bool is_ring, Ends ends,
                               double tolerance) {
  std::optional<EllipseArc> arc = ellipse;
  if (!is_ring && !(passes_through(ellipse, run.front()) && passes_through(ellipse, run.back()))) {
    if (ends == Ends::must_be_on_it) return {};
    arc = through_ends(ellipse, run);
  }
  if (!arc) return {};
  const auto is_near = [&](const Point2& p) {
    const Point2 on = arc->at(arc->parameter_of(p));
    return std::hypot(on.x - p.x, on.y - p.y) <= std::max(tolerance, 0.001);
  };
  double sweep = 0;
  for (std::size_t k = 0; k < run.size(); ++k) {
    if (!is_near(run[k])) return {};
    if (k + 1 == run.size()) break;
    const Point2 &p = run[k], &q = run[k + 1];
    if (!is_near({(p.x + q.x) / 2, (p.y + q.y) / 2})) return {};
    sweep += std::remainder(arc->parameter_of(q) - arc->parameter_of(p), 2 * std::numbers::pi);
  }
  arc->from = arc->parameter_of(run.front());
  if (is_ring) sweep = std::copysign(2 * std::numbers::pi, sweep);
  arc->to = arc->from + sweep;
  if (!(std::fabs(sweep) > 0) || arc->is_whole() != is_ring) return {};
  return DrawnArc{0, 0, *arc};
}

/// The arc of a run. Where its ends are cut in mid-edge they are off the circle: then the lines there stay straight, and the arc is of
/// the circle; where too few are left, or all vertices are off it a little, it is moved to the ends, unless the circle is known.
std::optional<DrawnArc> arc_of(const EllipseArc& ellipse, const Run& run, const std::vector<Point2>& points, double tolerance) {
  std::vector<Point2> all;
  for (std::size_t k = run.begin; k <= run.end; ++k) all.push_back(points[k % points.size()]);
  for (const Ends ends : {Ends::must_be_on_it, Ends::move_it}) {
    if (run.is_known && ends == Ends::move_it) break;
    for (const auto& [before, behind] : {std::pair{0U, 0U}, {1U, 0U}, {0U, 1U}, {1U, 1U}}) {
      const std::size_t left_out = before + behind;
      if (left_out > 0 && (run.is_ring || all.size() < run.fewest_lines() + left_out + 1)) break;
      auto arc = arc_of(ellipse, std::span(all).subspan(before, all.size() - left_out), run.is_ring, ends, tolerance);
      if (!arc) continue;
      arc->first_line = static_cast<std::uint32_t>(run.begin) + before;
      arc->end_line = static_cast<std::uint32_t>(run.end) - behind;
      return arc;
    }
  }
  return {};
}

/// The arcs of one polyline, whose lines are numbered from 0 on.
std::vector<DrawnArc> arcs_of(const PaperMap& map, const std::vector<Run>& runs, const std::vector<Point2>& points,
                              double tolerance) {
  std::vector<DrawnArc> arcs;
  for (const Run& run : runs) {
    const auto ellipse = map.image(run.circle);
    const auto arc = ellipse ? arc_of(*ellipse, run, points, tolerance) : std::nullopt;
    if (arc) arcs.push_back(*arc);
  }
  return arcs;
}

/// One polyline with what its lines show, and its arcs once they are found.
class CurvedPolyline {
 public:
  CurvedPolyline(Drawing& drawing, EdgesOfLines& edges, const Polyline& p) : drawing_(drawing), edges_(edges), p_(p) {}

  std::vector<DrawnArc> arcs(const Mesh& mesh, const PaperMap& map, const MarkedCircles& known, double tolerance,
                             bool keeps_start) {
    const std::size_t lines = p_.end_point - p_.first_point - (p_.closed ? 0 : 1);
    if (lines < least_lines && known.is_empty()) return {};
    RunFinder finder(mesh, map, known, tolerance);
    std::vector<Point2> points = points_on_paper();
    std::vector<Run> runs = finder.runs(points, p_.closed, edges_of_lines(lines));
    if (const std::size_t begin = better_start(runs, lines); p_.closed && !keeps_start && begin > 0) {
      begin_at(begin);
      points = points_on_paper();
      runs = finder.runs(points, p_.closed, edges_of_lines(lines));
    }
    return arcs_of(map, runs, points, tolerance);
  }

 private:
  /// Where a run begins or ends, if the polyline begins at one that may go on before; 0: none does.
  static std::size_t better_start(const std::vector<Run>& runs, std::size_t lines) {
    if (runs.empty() || runs.front().is_ring) return 0;
    if (runs.back().end == lines) return runs.back().begin;
    return runs.front().begin == 0 ? runs.front().end : 0;
  }
  std::vector<Point2> points_on_paper() const {
    std::vector<Point2> points;
    for (const PaperPoint& p : drawing_.points_of(p_)) points.push_back(in_millimetres(p));
    return points;
  }
  std::vector<std::span<const std::array<VertexId, 2>>> edges_of_lines(std::size_t lines) const {
    std::vector<std::span<const std::array<VertexId, 2>>> all;
    for (std::size_t k = 0; k < lines; ++k) all.push_back(std::as_const(edges_.rows)[edges_.row_of_line[p_.first_point + k]]);
    return all;
  }
  void begin_at(std::size_t line) {
    const auto rotate = [&](auto& of_points) {
      const auto first = of_points.begin() + p_.first_point;
      std::rotate(first, first + static_cast<std::ptrdiff_t>(line), of_points.begin() + p_.end_point);
    };
    rotate(drawing_.points);
    rotate(edges_.row_of_line);
  }

  Drawing& drawing_;
  EdgesOfLines& edges_;
  const Polyline& p_;
};

}  // namespace

void fit_arcs(Drawing& drawing, const Projection& projection, const MarkedCircles& known, EdgesOfLines& edges, double tolerance,
              bool keeps_starts) {
  drawing.arc_tolerance = tolerance;
  const PaperMap map(projection);
  std::vector<std::vector<DrawnArc>> found(drawing.polylines.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, found.size(), 16), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k)
      found[k] =
          CurvedPolyline(drawing, edges, drawing.polylines[k]).arcs(projection.mesh(), map, known, tolerance, keeps_starts);
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    Polyline& p = drawing.polylines[k];
    p.first_arc = static_cast<std::uint32_t>(drawing.arcs.size());
    for (DrawnArc arc : found[k]) {
      arc.first_line += p.first_point;
      arc.end_line += p.first_point;
      drawing.arcs.push_back(arc);
    }
    p.end_arc = static_cast<std::uint32_t>(drawing.arcs.size());
  }
}

}  // namespace hsr::internal
