#include "hsr/io/write/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hsr::internal {

namespace {

constexpr double pi = std::numbers::pi;

PaperPoint rounded(const Point2& p) { return {std::llround(p.x * 1000), std::llround(p.y * 1000)}; }

/// How fast an arc's point moves at t.
double speed(const EllipseArc& arc, double t) {
  const double c = std::cos(t), s = std::sin(t);
  return std::hypot(c * arc.short_axis.x - s * arc.long_axis.x, c * arc.short_axis.y - s * arc.long_axis.y);
}

/// Along the arc from t on, by Gauss's rule of three points.
double length_of(const EllipseArc& arc, double t, double step) {
  const double half = step / 2, off = half * std::sqrt(0.6);
  return std::fabs(half) * (5 * speed(arc, t + half - off) + 8 * speed(arc, t + half) + 5 * speed(arc, t + half + off)) / 9;
}

/// In how many steps the length of an arc is found.
int steps_of(const EllipseArc& arc) {
  return arc.is_circle() ? 1 : std::max(8, static_cast<int>(std::ceil(std::fabs(arc.sweep()) * 32)));
}

/// Where so much of an arc's length is behind.
double parameter_after(const EllipseArc& arc, double length) {
  const int n = steps_of(arc);
  const double step = arc.sweep() / n;
  double t = arc.from;
  for (int k = 0; k < n; ++k, t += step) {
    const double here = length_of(arc, t, step);
    if (length > here && k + 1 < n) {
      length -= here;
      continue;
    }
    double part = here > 0 ? std::clamp(length / here, 0.0, 1.0) : 0;
    for (int again = 0; again < 3; ++again)  // Newton's
      part += (length - length_of(arc, t, part * step)) / (speed(arc, t + part * step) * std::fabs(step));
    return t + part * step;
  }
  return arc.to;
}

Point2 direction(const EllipseArc& arc, double t) {
  const double way = arc.sweep() < 0 ? -1 : 1, c = way * std::cos(t), s = way * std::sin(t);
  return {c * arc.short_axis.x - s * arc.long_axis.x, c * arc.short_axis.y - s * arc.long_axis.y};
}

}  // namespace

double PathPart::length() const {
  if (!is_arc) return std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)) / 1000;
  const int n = steps_of(arc);
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += length_of(arc, arc.from + k * arc.sweep() / n, arc.sweep() / n);
  return sum;
}

PathPart PathPart::between(double begin, double end) const {
  const double all = length();
  PathPart part = *this;
  if (!is_arc) {
    const double x = static_cast<double>(to.x - from.x), y = static_cast<double>(to.y - from.y);
    const auto at = [&](double done) {
      return PaperPoint{from.x + std::llround(x * done / all), from.y + std::llround(y * done / all)};
    };
    if (begin > 0) part.from = at(begin);
    if (end < all) part.to = at(end);
    return part;
  }
  if (begin > 0) {
    part.arc.from = parameter_after(arc, begin);
    part.from = rounded(arc.at(part.arc.from));
  }
  if (end < all) {
    part.arc.to = parameter_after(arc, end);
    part.to = rounded(arc.at(part.arc.to));
  }
  return part;
}

Point2 PathPart::leaving() const {
  return is_arc ? direction(arc, arc.from) : Point2{static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
}
Point2 PathPart::arriving() const { return is_arc ? direction(arc, arc.to) : leaving(); }

Path path_of(std::span<const PaperPoint> points, bool closed) {
  Path path;
  path.closed = closed;
  for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k)
    path.parts.push_back({points[k], points[(k + 1) % points.size()]});
  return path;
}

Path path_of(const Drawing& drawing, const Polyline& p) {
  Path path;
  path.closed = p.closed;
  const std::uint32_t end = p.end_point - (p.closed ? 0 : 1);
  const auto point = [&](std::uint32_t k) { return drawing.points[k == p.end_point ? p.first_point : k]; };
  const auto arcs = drawing.arcs_of(p);
  auto next = arcs.begin();
  for (std::uint32_t line = p.first_point; line < end;) {
    const bool is_arc = next != arcs.end() && next->first_line == line;
    const std::uint32_t to = is_arc ? next->end_line : line + 1;
    path.parts.push_back({point(line), point(to), is_arc, is_arc ? next->ellipse : EllipseArc{}});
    if (is_arc && (next++)->ellipse.is_whole())  // nothing holds it to one of its points
      path.parts.back().from = path.parts.back().to = rounded(path.parts.back().arc.at(path.parts.back().arc.from));
    line = to;
  }
  return path;
}

std::vector<PathPart> at_most(const PathPart& part, double radians) {
  const double n = std::max(1.0, std::ceil(std::fabs(part.arc.sweep()) / radians - 1e-9));
  std::vector<PathPart> parts;
  PathPart next = part;
  for (double k = 0; k < n; ++k) {
    next.from = k == 0 ? part.from : next.to;
    next.arc.from = k == 0 ? part.arc.from : next.arc.to;
    next.arc.to = k + 1 < n ? part.arc.from + (k + 1) * part.arc.sweep() / n : part.arc.to;
    next.to = k + 1 < n ? rounded(part.arc.at(next.arc.to)) : part.to;
    parts.push_back(next);
  }
  return parts;
}

// A quarter of a circle by the usual curve is off by 0.00027 of the radius; a part of it by the sixth power of that part, less than
// which this is.
std::vector<Bezier> beziers(const PathPart& part, double tolerance) {
  const double wanted = std::max(tolerance / 100, 1e-4);
  const double radians = pi / 2 * std::min(1.0, std::pow(wanted / (0.000273 * part.arc.long_radius()), 1.0 / 6));
  std::vector<Bezier> curves;
  for (const PathPart& one : at_most(part, radians)) {
    const EllipseArc& arc = one.arc;
    const double reach = 4.0 / 3 * std::tan(arc.sweep() / 4);
    const auto tangent = [&](double t, double by) {
      const Point2 at = arc.at(t);
      const double c = by * std::cos(t), s = by * std::sin(t);
      return Point2{at.x + c * arc.short_axis.x - s * arc.long_axis.x, at.y + c * arc.short_axis.y - s * arc.long_axis.y};
    };
    curves.push_back({tangent(arc.from, reach), tangent(arc.to, -reach), one.to});
  }
  return curves;
}

std::vector<PaperPoint> flattened(const Path& path, double error) {
  std::vector<PaperPoint> points;
  if (path.parts.empty()) return points;
  points.push_back(path.parts.front().from);
  for (const PathPart& part : path.parts) {
    if (!part.is_arc) {
      points.push_back(part.to);
      continue;
    }
    const double least = 2 * std::acos(1 - std::min(error / part.arc.long_radius(), 0.3));
    for (const PathPart& chord : at_most(part, least)) points.push_back(chord.to);
  }
  if (path.closed) points.pop_back();
  return points;
}

}  // namespace hsr::internal
