#include "hsr/drawing/pen_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hsr/drawing/end_tree.h"
#include "hsr/drawing/pen_tour.h"

namespace hsr::internal {

namespace {

double distance(const PaperPoint& a, const PaperPoint& b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

/// Where each of some polylines is begun: its first or its last point, or if it is closed, any.
struct Start {
  std::uint32_t polyline, point;
};

/// The polylines of one layer and one object.
class PenSorter {
 public:
  PenSorter(const Drawing& drawing, std::size_t first, std::size_t end)
      : drawing_(drawing), first_(first), count_(end - first) {}

  /// The starts in the order in which they are drawn. @param pen where it is, and where it is left
  std::vector<Start> sorted(PaperPoint& pen) {
    PenTour tour = greedy(pen);
    shorten(strokes_, tour, pen);
    begin_closed_ones_near(tour, pen);
    shorten(strokes_, tour, pen);
    std::vector<Start> starts;
    for (const std::uint32_t pass : tour) {
      const std::uint32_t k = pass / 2;
      const bool turned = (pass & 1U) != 0 && !polyline(k).closed;
      starts.push_back(
          {static_cast<std::uint32_t>(first_ + k), turned ? static_cast<std::uint32_t>(points(k).size() - 1) : begin_[k]});
      pen = strokes_[k].ends[(pass & 1U) ^ 1U];
    }
    return starts;
  }

 private:
  const Polyline& polyline(std::uint32_t k) const { return drawing_.polylines[first_ + k]; }
  std::span<const PaperPoint> points(std::uint32_t k) const { return drawing_.points_of(polyline(k)); }

  /// The nearest start of those that are left, again and again.
  PenTour greedy(PaperPoint pen) {
    std::vector<PaperPoint> places;
    std::vector<Start> starts;
    std::vector<std::uint32_t> first_start = {0};
    for (std::uint32_t k = 0; k < count_; ++k) {
      const auto all = points(k);
      for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (!polyline(k).closed && i != 0 && i + 1 != all.size()) continue;
        places.push_back(all[i]);
        starts.push_back({k, i});
      }
      first_start.push_back(static_cast<std::uint32_t>(starts.size()));
    }
    EndTree tree(places);
    begin_.assign(count_, 0);
    strokes_.resize(count_);
    PenTour tour;
    while (const auto next = tree.nearest(pen)) {
      const auto [k, i] = starts[next->number];
      const auto all = points(k);
      const bool turned = !polyline(k).closed && i != 0;
      strokes_[k] = polyline(k).closed ? PenStroke{{all[i], all[i]}} : PenStroke{{all.front(), all.back()}};
      begin_[k] = polyline(k).closed ? i : 0;
      tour.push_back(2 * k + (turned ? 1 : 0));
      pen = strokes_[k].ends[turned ? 0 : 1];
      for (std::uint32_t s = first_start[k]; s < first_start[k + 1]; ++s) tree.take_out(s);
    }
    return tour;
  }

  void begin_closed_ones_near(const PenTour& tour, PaperPoint pen) {
    for (std::size_t t = 0; t < tour.size(); ++t) {
      const std::uint32_t k = tour[t] / 2;
      if (polyline(k).closed) {
        const PaperPoint* const next = t + 1 < tour.size() ? &strokes_[tour[t + 1] / 2].ends[tour[t + 1] & 1U] : nullptr;
        const auto all = points(k);
        const auto way = [&](const PaperPoint& p) { return distance(pen, p) + (next == nullptr ? 0 : distance(p, *next)); };
        const auto best = std::ranges::min_element(all, {}, way);
        begin_[k] = static_cast<std::uint32_t>(best - all.begin());
        strokes_[k] = {{*best, *best}};
      }
      pen = strokes_[k].ends[(tour[t] & 1U) ^ 1U];
    }
  }

  const Drawing& drawing_;
  std::size_t first_, count_;
  std::vector<PenStroke> strokes_;
  std::vector<std::uint32_t> begin_;  // of closed ones
};

/// Writes polylines anew, each where the one before ends as a part of it.
class PenWriter {
 public:
  explicit PenWriter(const Drawing& drawing) : from_(drawing) {}

  void add(const Start& start) {
    const Polyline& p = from_.polylines[start.polyline];
    const auto all = from_.points_of(p);
    std::vector<PaperPoint> run(all.begin(), all.end());
    std::vector<std::uint32_t> lines(all.size());  // by the point that they begin at; of the last of an open one none
    std::iota(lines.begin(), lines.end(), p.first_point);
    if (p.closed) {
      std::rotate(run.begin(), run.begin() + start.point, run.end());
      std::rotate(lines.begin(), lines.begin() + start.point, lines.end());
    } else if (start.point != 0) {
      std::reverse(run.begin(), run.end());
      std::reverse(lines.begin(), lines.end() - 1);
    }
    const bool goes_on = is_open_ && p.hidden == last_.hidden && p.edge_class == last_.edge_class && p.object == last_.object &&
                         !run_.empty() && run_.back() == run.front();
    if (!goes_on) finish();
    if (run_.empty()) {
      last_ = p;
      run_ = std::move(run);
      lines_ = std::move(lines);
      is_open_ = !p.closed;
    } else {
      run_.insert(run_.end(), run.begin() + 1, run.end());
      lines_.back() = lines.front();
      lines_.insert(lines_.end(), lines.begin() + 1, lines.end());
      if (p.closed) {
        run_.push_back(run.front());
        lines_.push_back(lines.front());
      }
    }
    const auto edges = from_.edges_of(p);
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    const auto faces = from_.faces_of(p);
    faces_.insert(faces_.end(), faces.begin(), faces.end());
  }

  /// @returns for each point the line that begins there
  std::vector<std::uint32_t> write_into(Drawing& drawing) {
    finish();
    drawing.polylines = std::move(to_.polylines);
    drawing.points = std::move(to_.points);
    drawing.edges = std::move(to_.edges);
    drawing.faces = std::move(to_.faces);
    return std::move(all_lines_);
  }

 private:
  void finish() {
    if (run_.empty()) return;
    Polyline p = last_;
    p.closed = !is_open_ || (run_.size() > 3 && run_.front() == run_.back());
    if (is_open_ && p.closed) {
      run_.pop_back();
      lines_.pop_back();
    }
    p.first_point = static_cast<std::uint32_t>(to_.points.size());
    to_.points.insert(to_.points.end(), run_.begin(), run_.end());
    all_lines_.insert(all_lines_.end(), lines_.begin(), lines_.end());
    p.end_point = static_cast<std::uint32_t>(to_.points.size());
    p.first_edge = static_cast<std::uint32_t>(to_.edges.size());
    append_unique(edges_, to_.edges);
    p.end_edge = static_cast<std::uint32_t>(to_.edges.size());
    p.first_face = static_cast<std::uint32_t>(to_.faces.size());
    append_unique(faces_, to_.faces);
    p.end_face = static_cast<std::uint32_t>(to_.faces.size());
    to_.polylines.push_back(p);
    run_.clear();
    lines_.clear();
  }
  template <class T>
  static void append_unique(std::vector<T>& some, std::vector<T>& all) {
    std::sort(some.begin(), some.end());
    all.insert(all.end(), some.begin(), std::unique(some.begin(), some.end()));
    some.clear();
  }

  const Drawing& from_;
  Drawing to_;
  Polyline last_;
  std::vector<PaperPoint> run_;
  std::vector<std::uint32_t> lines_, all_lines_;
  bool is_open_ = true;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace

PenTravel pen_travel(const Drawing& drawing) {
  PenTravel travel;
  PaperPoint pen;
  for (const Polyline& p : drawing.polylines) {
    const auto points = drawing.points_of(p);
    travel.up += distance(pen, points.front()) / 1000;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) travel.down += distance(points[k], points[k + 1]) / 1000;
    if (p.closed) travel.down += distance(points.back(), points.front()) / 1000;
    pen = p.closed ? points.front() : points.back();
  }
  return travel;
}

std::vector<std::uint32_t> sort_for_pen(Drawing& drawing) {
  PenWriter writer(drawing);
  PaperPoint pen;
  const std::vector<Polyline>& all = drawing.polylines;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    const Polyline& p = all[first];
    while (end < all.size() && all[end].hidden == p.hidden && all[end].edge_class == p.edge_class &&
           all[end].object == p.object)
      ++end;
    for (const Start& start : PenSorter(drawing, first, end).sorted(pen)) writer.add(start);
  }
  return writer.write_into(drawing);
}

}  // namespace hsr::internal
