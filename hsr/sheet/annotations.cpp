#include "hsr/sheet/annotations.h"

#include <algorithm>
#include <cmath>

#include "hsr/sheet/stroke_font.h"

namespace hsr::internal {

namespace {

constexpr double beyond = 3;  // of centre lines, mm
constexpr double arrow = 3;
constexpr double least_radius = 0.75;  // mm: smaller circles are dots
constexpr double tilt = 1e-3;          // the sine of what an axis may be off and still be seen along its length, or as a point

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point2 plus(const Point2& a, const Point2& b, double times = 1) { return {a.x + times * b.x, a.y + times * b.y}; }

Point2 unit(const Point2& a, const Point2& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return length > 0 ? Point2{(b.x - a.x) / length, (b.y - a.y) / length} : Point2{1, 0};
}

/// A chain on both sides of its middle, so that a dash is there.
struct CentreLine {
  Point2 middle, end;
};

/// The lines of one view, each once: circles behind one another have the same.
class CentreLines {
 public:
  explicit CentreLines(const std::vector<PaperTrace>& traces) : traces_(traces) {}

  void add(const Point2& from, const Point2& to) {
    const auto is_on = [](const PaperTrace& t, const Point2& p) {
      return std::fabs((p.x - t.point.x) * t.toward.x + (p.y - t.point.y) * t.toward.y) < near;
    };
    for (const PaperTrace& t : traces_)
      if (is_on(t, from) && is_on(t, to)) return;
    for (CentreLine& line : lines_) {
      if (!is_on({line.middle, across(line)}, from) || !is_on({line.middle, across(line)}, to)) continue;
      const double half = distance(line.middle, line.end);
      const auto is_within = [&](const Point2& p) { return distance(line.middle, p) <= half + near; };
      if (is_within(from) && is_within(to)) return;
      const Point2 middle = between(from, to), other = {2 * line.middle.x - line.end.x, 2 * line.middle.y - line.end.y};
      if (distance(middle, line.end) > distance(middle, to) + near || distance(middle, other) > distance(middle, to) + near)
        continue;
      line = {middle, to};  // it is part of the new one
      return;
    }
    lines_.push_back({between(from, to), to});
  }
  void draw(Sketch& sketch, Sketch::LayerIndex layer) const {
    for (const CentreLine& line : lines_) {
      sketch.line(layer, line.middle, line.end);
      sketch.line(layer, line.middle, {2 * line.middle.x - line.end.x, 2 * line.middle.y - line.end.y});
    }
  }

 private:
  static constexpr double near = 0.05;  // mm

  static double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }
  static Point2 between(const Point2& a, const Point2& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
  /// Square to a line, of length 1.
  static Point2 across(const CentreLine& line) {
    const Point2 along = unit(line.middle, line.end);
    return {-along.y, along.x};
  }

  const std::vector<PaperTrace>& traces_;
  std::vector<CentreLine> lines_;
};

}  // namespace

Point2 ViewOnPaper::at(const Point3& p) const {
  const Point3 d = minus(p, view_.frame.origin);
  return {origin_.x + scale_ * dot(d, view_.frame.right), origin_.y - scale_ * dot(d, view_.frame.up)};
}

Point2 ViewOnPaper::along(const Point3& direction) const {
  return {dot(direction, view_.frame.right), -dot(direction, view_.frame.up)};
}

bool ViewOnPaper::cuts(const ModelCircle& circle) const {
  if (!view_.section) return false;
  const Point3 &n = view_.section->normal, d = minus(circle.centre, view_.section->point);
  const double size = std::sqrt(dot(n, n)), along = dot(n, circle.axis) / size;
  return std::fabs(dot(d, n)) / size <= circle.radius * (std::sqrt(std::max(0.0, 1 - along * along)) + 1e-6);
}

PaperTrace trace_of(const ViewOnPaper& paper, const View& section) {
  const Point2 normal = paper.along(section.section->normal);
  const double length = std::hypot(normal.x, normal.y);
  return {paper.at(section.section->point), {normal.x / length, normal.y / length}};
}

void draw_centre_lines(Sketch& sketch, const std::string& view_name, const std::vector<ModelCircle>& circles, double reach,
                       const ViewOnPaper& view, const std::vector<PaperTrace>& traces, const SheetPens& pens) {
  std::vector<ModelCircle> kept;
  for (const ModelCircle& c : circles)
    if (c.radius * view.scale() >= least_radius) kept.push_back(c);
  CentreLines lines(traces);
  for (const ModelAxis& axis : axes_of(kept, reach)) {
    const Point2 along = view.along(axis.direction);
    const double length = std::hypot(along.x, along.y);
    if (length < tilt) {
      const Point2 centre = view.at(axis.point);
      const double half = axis.radius * view.scale() + beyond;
      lines.add({centre.x - half, centre.y}, {centre.x + half, centre.y});
      lines.add({centre.x, centre.y - half}, {centre.x, centre.y + half});
    } else if (length > std::sqrt(1 - tilt * tilt) && axis.last > axis.first) {
      const Point2 origin = view.at(axis.point), direction = {along.x / length, along.y / length};
      lines.add(plus(origin, direction, axis.first * view.scale() - beyond),
                plus(origin, direction, axis.last * view.scale() + beyond));
    }
  }
  lines.draw(sketch, sketch.layer(view_name + " centre lines", chain_pen(pens.narrow())));
}

void draw_dimension(Sketch& sketch, const DimensionLine& d, const SheetPens& pens) {
  constexpr double gap = 1, over = 2, lift = 0.8;
  const auto layer = sketch.layer("dimensions", continuous_pen(pens.narrow()));
  const Point2 along = unit(d.line_from, d.line_to);
  for (const auto& [point, end] : {std::pair{d.from, d.line_from}, {d.to, d.line_to}}) {
    const Point2 away = unit(point, end);
    sketch.line_beside_texts(layer, plus(point, away, gap), plus(end, away, over));
  }
  const double length = std::hypot(d.line_to.x - d.line_from.x, d.line_to.y - d.line_from.y);
  const bool is_upright = std::fabs(along.y) > std::fabs(along.x);
  const double text_width = StrokeFont(dimension_letters).width(d.text);
  const bool has_room = length >= 2 * arrow + 2;
  const double outside = has_room ? 0 : 2 * arrow;
  sketch.line_beside_texts(layer, plus(d.line_from, along, -outside), plus(d.line_to, along, outside));
  const double side = has_room ? -1 : 1;
  sketch.arrow_head(layer, d.line_from, {side * along.x, side * along.y}, arrow);
  sketch.arrow_head(layer, d.line_to, {-side * along.x, -side * along.y}, arrow);
  Point2 at = {(d.line_from.x + d.line_to.x) / 2, (d.line_from.y + d.line_to.y) / 2};
  // Text that is wider than the line stands beyond its end.
  if (text_width > length - 1) at = plus(d.line_to, along, outside + text_width / 2 + 1);
  if (is_upright)
    sketch.text("dimensions", d.text, dimension_letters, {at.x - lift, at.y}, Anchor::middle, Reading::upwards);
  else
    sketch.text("dimensions", d.text, dimension_letters, {at.x, at.y - lift}, Anchor::middle);
}

void draw_cutting_line(Sketch& sketch, const std::string& letter, const Point2& from, const Point2& to, const Point2& toward,
                       const SheetPens& pens) {
  constexpr double end = 6, tail = 9, letter_gap = 1.5;
  const auto chain = sketch.layer("cutting lines", chain_pen(pens.narrow()));
  const auto thick = sketch.layer("cutting lines ends", continuous_pen(2 * pens.wide));
  const auto arrows = sketch.layer("cutting lines arrows", continuous_pen(pens.wide));
  const Point2 along = unit(from, to);
  sketch.line(chain, from, to);
  for (const auto& [at, inward] : {std::pair{from, 1.0}, {to, -1.0}}) {
    sketch.line(thick, at, plus(at, along, inward * end));
    const Point2 tip = plus(at, along, inward * end / 2), start = plus(tip, toward, -tail);
    sketch.line(arrows, start, plus(tip, toward, -pens.wide - 0.5 * 4));
    sketch.arrow_head(arrows, plus(tip, toward, -pens.wide), toward, 4);
    const double outward = -inward * (letter_gap + label_letters / 2);
    const Point2 letter_at = plus(plus(start, along, outward), toward, label_letters / 2);
    sketch.text("cutting lines", letter, label_letters, {letter_at.x, letter_at.y + label_letters / 2}, Anchor::middle);
  }
}

void draw_label(Sketch& sketch, const std::string& text, const Point2& at) {
  sketch.text("labels", text, label_letters, at, Anchor::middle);
}

}  // namespace hsr::internal
