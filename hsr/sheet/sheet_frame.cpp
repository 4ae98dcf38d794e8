#include "hsr/sheet/sheet_frame.h"

#include <string>

#include "hsr/sheet/title_block.h"

namespace hsr::internal {

namespace {

constexpr double band = 5;    // of the grid, outside the frame
constexpr double field = 50;  // from the middle of the sheet on
constexpr double letter_height = 3.5;
constexpr double mark_inside = 5;  // of a centring mark, inside the frame

std::string letter(int k) { return std::string(1, "ABCDEFGHJKLMNPQRSTUVWXYZ"[k % 24]); }

/// Where fields end along one side, from its beginning to its end. What is left at the corners is part of the last field where it is less
/// than 20 mm, which gives each size of paper the number of fields that ISO 5457 has for it.
std::vector<double> borders(double begin, double end, double middle) {
  constexpr double least = 20;
  std::vector<double> all = {begin};
  double first = middle;
  while (first - field >= begin + least) first -= field;
  for (double x = first; x <= end - least; x += field) all.push_back(x);
  all.push_back(end);
  return all;
}

/// A side of the frame, and the outer border of the grid along it.
struct Side {
  double inner, outer;
};

/// The fields along some sides that are parallel.
/// @param to_point from a place along the sides and one across to the page
template <class ToPoint, class Name>
void draw_fields(Sketch& sketch, Sketch::LayerIndex lines, const std::vector<double>& at, const std::vector<Side>& sides,
                 const ToPoint& to_point, const Name& name) {
  for (const auto& [inner, outer] : sides)
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      if (k > 0) sketch.line(lines, to_point(at[k], inner), to_point(at[k], outer));
      const Point2 middle = to_point((at[k] + at[k + 1]) / 2, (inner + outer) / 2);
      if (at[k + 1] - at[k] > letter_height)
        sketch.text("frame", name(static_cast<int>(k)), letter_height, {middle.x, middle.y + letter_height / 2},
                    Anchor::middle);
    }
}

}  // namespace

void draw_frame(Sketch& sketch, const SheetFormat& format) {
  const PaperFrame f = format.frame();
  const auto frame = sketch.layer("frame", continuous_pen(0.7)), grid = sketch.layer("frame grid", continuous_pen(0.35));
  sketch.rectangle(frame, f);
  const double x = format.width / 2, y = format.height / 2;
  const bool is_free_at_bottom = x < title_block_place(f).left;
  for (const auto& [from, to] : {std::pair<Point2, Point2>{{x, f.top - band}, {x, f.top + mark_inside}},
                                 {{x, f.bottom + band}, {x, f.bottom - (is_free_at_bottom ? mark_inside : 0)}},
                                 {{f.left - band, y}, {f.left + mark_inside, y}},
                                 {{f.right + band, y}, {f.right - mark_inside, y}}})
    sketch.line(frame, from, to);
  const bool is_full = format.has_full_grid;
  if (is_full) {
    sketch.rectangle(grid, {f.left - band, f.top - band, f.right + band, f.bottom + band});
  } else {
    sketch.polyline(grid,
                    std::array<Point2, 5>{{{f.left, f.top},
                                           {f.left, f.top - band},
                                           {f.right + band, f.top - band},
                                           {f.right + band, f.bottom},
                                           {f.right, f.bottom}}},
                    false);
  }
  std::vector<Side> rows = {{f.top, f.top - band}}, columns = {{f.right, f.right + band}};
  if (is_full) {
    rows.push_back({f.bottom, f.bottom + band});
    columns.push_back({f.left, f.left - band});
  }
  draw_fields(
      sketch, grid, borders(f.left, f.right, x), rows,
      [](double along, double across) {
        return Point2{along, across};
      },
      [](int k) { return std::to_string(k + 1); });
  draw_fields(
      sketch, grid, borders(f.top, f.bottom, y), columns,
      [](double along, double across) {
        return Point2{across, along};
      },
      letter);
}

}  // namespace hsr::internal
