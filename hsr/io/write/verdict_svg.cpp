#include "hsr/io/write/verdict_svg.h"

#include <algorithm>
#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"
#include "hsr/painter/verify/what_is_left.h"

namespace hsr::internal {

namespace {

struct Shape {
  std::vector<std::array<double, 2>> points;
  bool is_later = false;
};

/// From the frame to the page. For the eye: in doubles.
struct Sheet {
  double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;
  static constexpr double size = 180, margin = 10;

  void add(const std::array<double, 2>& p) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
    bottom = std::min(bottom, p[1]);
    top = std::max(top, p[1]);
  }
  double scale() const {
    const double extent = std::max(right - left, top - bottom);
    return extent > 0 ? size / extent : 1;
  }
  PaperPoint place(const std::array<double, 2>& p) const {
    const auto thousandths = [](double mm) { return static_cast<std::int64_t>(std::llround(mm * 1000)); };
    return {thousandths(margin + (p[0] - left) * scale()), thousandths(margin + (top - p[1]) * scale())};
  }
  double width() const { return std::max(1.0, (right - left) * scale()) + 2 * margin; }
  double height() const { return std::max(1.0, (top - bottom) * scale()) + 2 * margin; }
};

/// The images of what the near plane and sections leave of a polygon.
std::vector<std::vector<std::array<double, 2>>> seen(const PaintedPolygon& polygon, const View& view) {
  std::vector<std::vector<std::array<double, 2>>> images;
  for (const WhatIsLeft::Ring& ring : WhatIsLeft(view).of(polygon.corners)) {
    std::vector<std::array<double, 2>>& points = images.emplace_back();
    for (const RationalVector& p : ring) {
      const auto at = image(view, p);
      points.push_back({at[0].to_double(), at[1].to_double()});
    }
  }
  return images;
}

}  // namespace

std::string verdict_svg(const Verdict& verdict, const std::vector<PaintedPolygon>& far_to_near, const View& view,
                        const SvgOptions& options) {
  std::vector<Shape> shapes;
  std::vector<std::array<double, 2>> witnesses;
  Sheet page;
  const auto add = [&](std::uint32_t polygon, bool is_later) {
    for (auto& points : seen(far_to_near[polygon], view)) {
      for (const auto& p : points) page.add(p);
      shapes.push_back({std::move(points), is_later});
    }
  };
  const auto mark = [&](const Witness& w) { witnesses.push_back({w.place[0].to_double(), w.place[1].to_double()}); };
  for (const Violation& v : verdict.first) {
    add(v.earlier, false);
    add(v.later, true);
    mark(v.witness);
  }
  if (verdict.first.empty())
    for (std::uint32_t k = 0; k < std::min<std::size_t>(far_to_near.size(), 10'000); ++k) add(k, false);
  std::string out;
  append_svg_start(out, page.width(), page.height(), options);
  for (const Shape& shape : shapes) {
    std::vector<PaperPoint> points;
    for (const auto& p : shape.points) points.push_back(page.place(p));
    out += "<path d=\"";
    append_points(out, points);
    out += shape.is_later ? "Z\" fill=\"#d62728\" fill-opacity=\"0.35\" stroke=\"#d62728\" stroke-width=\"0.35\"/>\n"
                          : "Z\" fill=\"#1f77b4\" fill-opacity=\"0.35\" stroke=\"#1f77b4\" stroke-width=\"0.35\"/>\n";
  }
  for (const auto& w : witnesses) {
    const PaperPoint p = page.place(w);
    out += "<circle cx=\"";
    append_coordinate(out, p.x);
    out += "\" cy=\"";
    append_coordinate(out, p.y);
    out += "\" r=\"1.5\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.35\"/>\n";
  }
  out += "</svg>\n";
  return out;
}

}  // namespace hsr::internal
