#include "hsr/io/write/painted_paths.h"

#include <algorithm>
#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/line_paths.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

/// Continuous, whatever the pen: what is painted over is not dashed as well.
void append_stroke(std::string& out, std::span<const PaperPoint> points, bool closed, Pen pen) {
  pen.dashes.clear();
  append_pen(out, pen);
  append_path(out, points);
  out += closed ? "h S\n" : "S\n";
}

PaperFrame frame_around(const Fills& fills, std::span<const Fill> some) {
  PaperFrame frame = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Fill& fill : some)
    for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r)
      for (const PaperPoint& p : fills.rings[r]) {
        const double x = static_cast<double>(p.x) / 1000, y = static_cast<double>(p.y) / 1000;
        frame = {std::min(frame.left, x), std::min(frame.top, y), std::max(frame.right, x), std::max(frame.bottom, y)};
      }
  return frame;
}

void append_fill(std::string& out, const Fills& fills, const Fill& fill) {
  for (std::size_t k = 0; k < 3; ++k) {
    append_length(out, std::round(fill.colour[k] / 255.0 * 1e5) / 1e5);
    out += ' ';
  }
  out += "rg\n";
  for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) {
    if (fills.rings[r].empty()) continue;
    append_path(out, fills.rings[r]);
    out += "h\n";
  }
  out += "f\n";
}

}  // namespace

double points_of(double mm) { return std::round(mm * 360e9 / 127) / 1e9; }

void append_page_space(std::string& out, double height) {
  append_length(out, points_of(1));
  out += " 0 0 ";
  append_length(out, -points_of(1));
  out += " 0 ";
  append_length(out, points_of(height));
  out += " cm\n1 j\n";
}

std::string name_of_opacity(double opacity) { return "/O" + std::to_string(std::lround(opacity * 1000)); }

void append_fills(std::string& out, const Fills& fills, const Pens& pens,
                  const std::function<std::string(const std::string&, const PaperFrame&)>& sheet) {
  std::string opacity = name_of_opacity(1);
  const auto set_opacity = [&](double to) {
    if (name_of_opacity(to) == opacity) return;
    opacity = name_of_opacity(to);
    out += opacity + " gs\n";
  };
  std::string contents;  // of the sheet at hand
  PaperFrame frame = {};
  bool is_sheet = false;
  for_each_painted(
      fills,
      [&](std::span<const Fill> together) {
        set_opacity(together[0].opacity);
        frame = frame_around(fills, together);
        contents.clear();
        is_sheet = true;
      },
      [&](const Fill& fill, double fill_opacity) {
        if (!is_sheet) set_opacity(fill_opacity);
        append_fill(is_sheet ? contents : out, fills, fill);
      },
      [&] {
        out += sheet(contents, frame);
        is_sheet = false;
      },
      [&](const FillLine& line) {
        set_opacity(1);
        append_stroke(out, fills.points_of(line), line.closed, pens.of(false, line.edge_class));
      });
  set_opacity(1);
}

}  // namespace hsr::internal
