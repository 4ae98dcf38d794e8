#include "hsr/sheet/round_part.h"

#include <algorithm>
#include <cmath>

namespace hsr::internal {

namespace {

/// Between two places along a straight line, 0 at its first end and 1 at its last.
struct Stretch {
  double from, to;
};

/// The part of a straight line in the circle; empty where from >= to.
Stretch in_circle(const Point2& a, const Point2& b, const Point2& centre, double radius) {
  const double dx = b.x - a.x, dy = b.y - a.y, x = a.x - centre.x, y = a.y - centre.y;
  const double square = dx * dx + dy * dy, half = x * dx + y * dy, rest = x * x + y * y - radius * radius;
  const double root = half * half - square * rest;
  if (!(square > 0) || !(root > 0)) return {0, 0};
  return {std::max(0.0, (-half - std::sqrt(root)) / square), std::min(1.0, (-half + std::sqrt(root)) / square)};
}

Point2 in_millimetres(const PaperPoint& p) { return {static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000}; }

/// Polylines that are made of the pieces of one.
class Pieces {
 public:
  Pieces(Drawing& to, const Polyline& of) : to_(to), of_(of) {}

  void add(const PaperPoint& from, const PaperPoint& to) {
    if (from == to) return;
    if (!open_ || to_.points.back() != from) {
      end();
      first_ = static_cast<std::uint32_t>(to_.points.size());
      to_.points.push_back(from);
      open_ = true;
    }
    to_.points.push_back(to);
  }
  void end() {
    if (!open_) return;
    Polyline p = of_;
    p.closed = false;
    p.first_arc = p.end_arc = 0;
    p.first_point = first_;
    p.end_point = static_cast<std::uint32_t>(to_.points.size());
    to_.polylines.push_back(p);
    open_ = false;
  }

 private:
  Drawing& to_;
  const Polyline& of_;
  std::uint32_t first_ = 0;
  bool open_ = false;
};

}  // namespace

Drawing round_part(const Drawing& drawing, const Point2& centre, double radius) {
  Drawing part = drawing;
  part.polylines.clear();
  part.points.clear();
  part.arcs.clear();
  for (const Polyline& p : drawing.polylines) {
    Pieces pieces(part, p);
    const auto points = drawing.points_of(p);
    for (std::size_t k = 0; k + (p.closed ? 0 : 1) < points.size(); ++k) {
      const PaperPoint &from = points[k], &to = points[(k + 1) % points.size()];
      const Stretch s = in_circle(in_millimetres(from), in_millimetres(to), centre, radius);
      if (!(s.from < s.to)) continue;
      const auto at = [&](double t) -> PaperPoint {
        if (t == 0) return from;
        if (t == 1) return to;
        return {from.x + std::llround(t * static_cast<double>(to.x - from.x)),
                from.y + std::llround(t * static_cast<double>(to.y - from.y))};
      };
      pieces.add(at(s.from), at(s.to));
    }
    pieces.end();
  }
  return part;
}

}  // namespace hsr::internal
