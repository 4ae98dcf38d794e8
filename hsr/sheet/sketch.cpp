#include "hsr/sheet/sketch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "hsr/sheet/paper_box.h"
#include "hsr/sheet/stroke_font.h"

namespace hsr::internal {

namespace {

PaperPoint on_paper(const Point2& p) { return {std::llround(p.x * 1000), std::llround(p.y * 1000)}; }

}  // namespace

Pen continuous_pen(double width) { return {width}; }
Pen chain_pen(double width) { return {width, {0, 0, 0, 255}, {24 * width, 3 * width, 0.5 * width, 3 * width}}; }

Sketch::LayerIndex Sketch::layer(const std::string& name, const Pen& pen) {
  const auto found = std::ranges::find(layers_, name, &Layer::name);
  if (found != layers_.end()) return static_cast<LayerIndex>(found - layers_.begin());
  layers_.push_back({name, pen, {}});
  return layers_.size() - 1;
}

void Sketch::polyline(LayerIndex layer, std::span<const Point2> points, bool closed) {
  layers_[layer].strokes.push_back({{points.begin(), points.end()}, closed});
}

void Sketch::line_beside_texts(LayerIndex layer, const Point2& from, const Point2& to) {
  std::vector<std::array<double, 2>> gaps;  // in shares of the way
  for (const PaperFrame& text : texts_)
    if (const auto gap = part_within(text, from, to)) gaps.push_back(*gap);
  std::ranges::sort(gaps);
  gaps.push_back({1, 1});
  const auto at = [&](double s) { return Point2{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)}; };
  double done = 0;
  for (const auto& [enters, leaves] : gaps) {
    if (enters > done) line(layer, at(done), at(enters));
    done = std::max(done, leaves);
  }
}

void Sketch::rectangle(LayerIndex layer, const PaperFrame& f) {
  polyline(layer, std::array<Point2, 4>{{{f.left, f.top}, {f.right, f.top}, {f.right, f.bottom}, {f.left, f.bottom}}}, true);
}

void Sketch::circle(LayerIndex layer, const Point2& centre, double radius) {
  constexpr int corners = 72;
  Stroke stroke{{}, true, radius, centre};
  for (int k = 0; k < corners; ++k) {
    const double t = 2 * std::numbers::pi * k / corners;
    stroke.points.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)});
  }
  layers_[layer].strokes.push_back(std::move(stroke));
}

void Sketch::arrow_head(LayerIndex layer, const Point2& tip, const Point2& direction, double length) {
  const double pen = layers_[layer].pen.width, half = length * std::tan(std::numbers::pi / 24);  // 15 degrees in all
  const int lines = std::max(2, static_cast<int>(std::ceil(2 * half / (0.8 * pen))));
  std::vector<Point2> fan;
  for (int k = 0; k <= lines; ++k) {
    const double across = half * (2.0 * k / lines - 1);
    const Point2 base = {tip.x - length * direction.x - across * direction.y,
                         tip.y - length * direction.y + across * direction.x};
    if (k % 2 == 0)
      fan.insert(fan.end(), {tip, base});
    else
      fan.insert(fan.end(), {base, tip});
  }
  fan.erase(std::unique(fan.begin(), fan.end()), fan.end());
  polyline(layer, fan, false);
  polyline(layer,
           std::array<Point2, 2>{
               {{tip.x - length * direction.x + half * direction.y, tip.y - length * direction.y - half * direction.x},
                {tip.x - length * direction.x - half * direction.y, tip.y - length * direction.y + half * direction.x}}},
           false);
}

void Sketch::text(const std::string& group, std::string_view text, double height, const Point2& at, Anchor anchor,
                  Reading reading, double widest) {
  if (text.empty()) return;
  const LayerIndex of_text =
      layer(group + " text " + std::to_string(std::lround(10 * height)), continuous_pen(std::round(height * 10) / 100));
  const StrokeFont font(height);
  const double width = font.width(text), narrower = width > widest ? widest / width : 1;
  const double begin = anchor == Anchor::left ? 0 : anchor == Anchor::middle ? -width * narrower / 2 : -width * narrower;
  constexpr double beside = 0.8;  // mm of a text no line runs
  PaperFrame around = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (TextStroke& stroke : font.strokes(text, {0, 0})) {
    for (Point2& p : stroke) {
      const double along = begin + narrower * p.x, down = p.y;
      p = reading == Reading::across ? Point2{at.x + along, at.y + down} : Point2{at.x + down, at.y - along};
      around = {std::min(around.left, p.x - beside), std::min(around.top, p.y - beside), std::max(around.right, p.x + beside),
                std::max(around.bottom, p.y + beside)};
    }
    polyline(of_text, stroke, false);
  }
  if (around.left < around.right) texts_.push_back(around);  // a text of blanks has no strokes
}

void Sketch::append_to(Drawing& drawing) const {
  for (const Layer& layer : layers_) {
    NamedLayer named{layer.name, layer.pen, static_cast<std::uint32_t>(drawing.polylines.size()), 0};
    for (const Stroke& stroke : layer.strokes) {
      Polyline p;
      p.closed = stroke.closed;
      p.first_point = static_cast<std::uint32_t>(drawing.points.size());
      p.first_edge = p.end_edge = static_cast<std::uint32_t>(drawing.edges.size());
      p.first_face = p.end_face = static_cast<std::uint32_t>(drawing.faces.size());
      p.first_arc = static_cast<std::uint32_t>(drawing.arcs.size());
      for (const Point2& at : stroke.points) drawing.points.push_back(on_paper(at));
      check_countable(drawing.points.size(), "points of a drawing");
      p.end_point = static_cast<std::uint32_t>(drawing.points.size());
      if (stroke.radius > 0)
        drawing.arcs.push_back(
            {p.first_point, p.end_point, {stroke.centre, {stroke.radius, 0}, {0, stroke.radius}, 0, 2 * std::numbers::pi}});
      p.end_arc = static_cast<std::uint32_t>(drawing.arcs.size());
      drawing.polylines.push_back(p);
    }
    named.end_polyline = static_cast<std::uint32_t>(drawing.polylines.size());
    drawing.layers.push_back(std::move(named));
  }
}

}  // namespace hsr::internal
