#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hsr/io/write/dashes.h"
#include "tests/io/write/drawn_scene.h"

namespace hsr {

/// A picture of a page as a program rendered it, row by row from the top, three bytes to a pixel.
struct RenderedPage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  const std::uint8_t* at(int x, int y) const { return &bytes[3 * (static_cast<std::size_t>(y) * width + x)]; }
};

/// What a picture of the page must show, from the segments and fragments themselves: black where a visible line runs, the colour of
/// the face or of the paper where none does, and dashes where a hidden one does.
class ExactPicture {
 public:
  struct Wrong {
    int lines = 0, dashes = 0, areas = 0;  ///< samples
    int seen = 0;                          ///< all that were compared
    int all() const { return lines + dashes + areas; }
  };

  ExactPicture(const DrawnScene& scene, const Drawing& drawing) : drawing_(drawing) {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    const std::vector<Segment> all = segments(scene.scene, scene.lines);
    for (const Segment& s : all)
      for (const PlacedPoint* p : {&s.from, &s.to})
        for (int k = 0; k < 2; ++k) {
          const double x = k == 0 ? p->paper.x : p->paper.y;
          low[k] = std::min(low[k], x);
          high[k] = std::max(high[k], x);
        }
    const auto placed = [&](const PlacedPoint& p) {
      return Point2{DrawnScene::width / 2 + DrawnScene::scale * (p.paper.x - (low[0] + high[0]) / 2),
                    DrawnScene::height / 2 - DrawnScene::scale * (p.paper.y - (low[1] + high[1]) / 2)};
    };
    for (const Segment& s : all) {
      const bool is_thin = s.is_hidden || s.edge_class == EdgeClass::smooth || s.edge_class == EdgeClass::joint;
      strokes_.push_back({placed(s.from), placed(s.to), is_thin ? 0.125 : 0.25, s.is_hidden});
    }
    const std::vector<Colour>& colours = scene.colours;
    for (const PlacedPolygon& polygon : polygons(scene.scene, scene.fragments)) {
      Area& area = areas_.emplace_back();
      area.colour = colours[polygon.face.value];
      for (const auto& ring : polygon.rings)
        for (std::size_t k = 0; k < ring.size(); ++k)
          area.sides.push_back({placed(ring[k]), placed(ring[(k + 1) % ring.size()])});
    }
  }

  /// @param dots pixels to the millimetre @param margin of edges and rounding, mm @param filled the fills are to be seen, too
  Wrong compare(const RenderedPage& page, double dots, bool filled, double margin) const {
    Wrong wrong;
    for (int y = 0; y < page.height; ++y)
      for (int x = y % 3; x < page.width; x += 3) {
        const Point2 p = {(x + 0.5) / dots, (y + 0.5) / dots};
        compare_at(p, page.at(x, y), filled, margin, wrong);
      }
    compare_dashes(page, dots, margin, wrong);
    return wrong;
  }

 private:
  struct Stroke {
    Point2 a, b;
    double half_width;
    bool is_hidden;
  };

  struct Area {
    Colour colour;
    std::vector<std::array<Point2, 2>> sides;
  };

  static double distance(const Point2& p, const Point2& a, const Point2& b) {
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double t = square == 0 ? 0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
  }

  void compare_at(const Point2& p, const std::uint8_t* pixel, bool filled, double margin, Wrong& wrong) const {
    bool is_inked = false, is_clear = true;
    for (const Stroke& s : strokes_) {
      const double d = distance(p, s.a, s.b);
      if (!s.is_hidden && d < s.half_width - margin) is_inked = true;
      if (d < s.half_width + margin) is_clear = false;
    }
    if (is_inked) {
      ++wrong.seen;
      if (pixel[0] > 40 || pixel[1] > 40 || pixel[2] > 40) ++wrong.lines;
      return;
    }
    if (!is_clear) return;
    Colour colour = {255, 255, 255, 255};
    if (filled && !find_fill(p, margin, colour)) return;
    ++wrong.seen;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(int(pixel[k]) - int(colour[k])) > 2) {
        ++wrong.areas;
        return;
      }
  }

  /// The colour of the visible face at p; false: near a border of one.
  bool find_fill(const Point2& p, double margin, Colour& colour) const {
    for (const Area& area : areas_) {
      bool is_inside = false;
      for (const auto& [a, b] : area.sides) {
        if (distance(p, a, b) < margin) return false;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
      }
      if (is_inside) colour = area.colour;
    }
    return true;
  }

  /// On hidden lines, where no visible one is near: ink on dashes, none on gaps.
  void compare_dashes(const RenderedPage& page, double dots, double margin, Wrong& wrong) const {
    for (const Polyline& p : drawing_.polylines) {
      if (!p.hidden) continue;
      const internal::DashedPath path =
          internal::dashed_path(internal::path_of(drawing_.points_of(p), p.closed), drawing_.pens.of(true, p.edge_class));
      std::vector<PaperPoint> points = {path.path.parts.front().from};
      for (const internal::PathPart& part : path.path.parts) points.push_back(part.to);
      double run = 0, begin = 0,
             end = path.lengths[0];  // of the segments before, and where the dash or gap k is along the line
      std::size_t k = 0;
      for (std::size_t s = 0; s + 1 < points.size(); ++s) {
        const double x = double(points[s + 1].x - points[s].x) / 1000, y = double(points[s + 1].y - points[s].y) / 1000;
        const double length = std::hypot(x, y);
        for (double at = 0; at < length; at += 0.5 / dots) {
          while (run + at > end) {
            begin = end;
            end += path.lengths[++k % path.lengths.size()];
          }
          if (run + at - begin < margin || end - run - at < margin) continue;
          const Point2 q = {double(points[s].x) / 1000 + at / length * x, double(points[s].y) / 1000 + at / length * y};
          if (is_near_another(q, points[s], points[s + 1])) continue;
          const std::uint8_t* pixel = page.at(int(q.x * dots), int(q.y * dots));
          ++wrong.seen;
          if ((pixel[0] < 110) != (k % 2 == 0)) ++wrong.dashes;
        }
        run += length;
      }
    }
  }
  bool is_near_another(const Point2& q, const PaperPoint& a, const PaperPoint& b) const {
    for (const Polyline& p : drawing_.polylines) {
      const auto points = drawing_.points_of(p);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const PaperPoint &i = points[k], &j = points[(k + 1) % points.size()];
        if (k + 1 == points.size() && !p.closed) continue;
        if ((i == a && j == b) || (i == b && j == a)) continue;
        if (distance(q, {double(i.x) / 1000, double(i.y) / 1000}, {double(j.x) / 1000, double(j.y) / 1000}) < 0.5) return true;
      }
    }
    return false;
  }

  const Drawing& drawing_;
  std::vector<Stroke> strokes_;
  std::vector<Area> areas_;
};

}  // namespace hsr
