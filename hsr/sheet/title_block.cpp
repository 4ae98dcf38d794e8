#include "hsr/sheet/title_block.h"

#include <array>

namespace hsr::internal {

namespace {

constexpr double width = 180, height = 36, row = 9;
constexpr double margin = 1.2;  // of text in a field
constexpr double caption = 1.8, value = 2.5, large = 3.5, largest = 5;

/// A field: where it is in the block, what it is called, and what it says.
struct Field {
  double x, y, width, height;
  const char* name;
  std::string text;
  double letters = value;  ///< height of its letters
};

void draw_field(Sketch& sketch, Sketch::LayerIndex lines, const PaperFrame& block, const Field& f) {
  const double x = block.left + f.x, y = block.top + f.y;
  sketch.rectangle(lines, {x, y, x + f.width, y + f.height});
  sketch.text("title block", f.name, caption, {x + margin, y + margin + caption});
  sketch.text("title block", f.text, f.letters, {x + margin, y + f.height - margin - 0.3}, Anchor::left, Reading::across,
              f.width - 2 * margin);
}

/// A cone seen from the side and from its small end, with the view on the side that the angle says.
void draw_projection_symbol(Sketch& sketch, const PaperFrame& field, ProjectionAngle angle, double wide) {
  const auto lines = sketch.layer("title block symbol", continuous_pen(wide));
  const auto axes = sketch.layer("title block symbol axes", chain_pen(wide / 2));
  const double y = (field.top + field.bottom) / 2, small = 1.3, large_end = 2.6, length = 5.2;
  const double middle = (field.left + field.right) / 2;
  // First angle: the view from the left, of the small end, is on the right of the side view.
  const double side = angle == ProjectionAngle::first ? middle - 8.5 : middle + 3.3;
  const double end = angle == ProjectionAngle::first ? middle + 5 : middle - 5;
  sketch.polyline(lines,
                  std::array<Point2, 4>{
                      {{side, y - small}, {side + length, y - large_end}, {side + length, y + large_end}, {side, y + small}}},
                  true);
  sketch.circle(lines, {end, y}, small);
  sketch.circle(lines, {end, y}, large_end);
  const double over = 1;
  sketch.line(axes, {side - over, y}, {side + length + over, y});
  sketch.line(axes, {end - large_end - over, y}, {end + large_end + over, y});
  sketch.line(axes, {end, y - large_end - over}, {end, y + large_end + over});
}

}  // namespace

PaperFrame title_block_place(const PaperFrame& frame) {
  return {frame.right - width, frame.bottom - height, frame.right, frame.bottom};
}

void draw_title_block(Sketch& sketch, const PaperFrame& place, const TitleBlock& t, const std::string& scale,
                      const std::string& format, ProjectionAngle angle) {
  const auto border = sketch.layer("title block border", continuous_pen(0.7));
  const auto lines = sketch.layer("title block", continuous_pen(0.35));
  sketch.polyline(
      border, std::array<Point2, 3>{{{place.left, place.bottom}, {place.left, place.top}, {place.right, place.top}}}, false);
  const Field fields[] = {
      {0, 0, 45, row, "Creator", t.creator},
      {45, 0, 45, row, "Approved by", t.approver},
      {90, 0, 50, row, "Document type", t.document_type},
      {140, 0, 40, row, "Material", t.material},
      {0, row, 60, 2 * row, "Legal owner", t.owner, large},
      {0, 3 * row, 22, row, "Scale", scale, large},
      {22, 3 * row, 38, row, "Projection", ""},
      {60, 3 * row, 54, row, "Identification number", t.number, large},
      {114, 3 * row, 10, row, "Rev.", t.revision, large},
      {124, 3 * row, 22, row, "Date of issue", t.date},
      {146, 3 * row, 10, row, "Size", format},
      {156, 3 * row, 9, row, "Lang.", t.language},
      {165, 3 * row, 15, row, "Sheet", t.sheet},
  };
  for (const Field& field : fields) draw_field(sketch, lines, place, field);
  const double x = place.left + 60, y = place.top + row;
  sketch.text("title block", "Title, supplementary title", caption, {x + margin, y + margin + caption});
  const double widest = place.right - x - 2 * margin;
  sketch.text("title block", t.title, largest, {x + margin, y + (t.subtitle.empty() ? 14 : 10.6)}, Anchor::left,
              Reading::across, widest);
  sketch.text("title block", t.subtitle, large, {x + margin, y + 2 * row - margin - 0.3}, Anchor::left, Reading::across,
              widest);
  draw_projection_symbol(sketch, {place.left + 22 + 12, place.top + 3 * row, place.left + 60, place.bottom}, angle, 0.35);
}

}  // namespace hsr::internal
