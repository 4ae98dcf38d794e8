#include "hsr/sheet/title_block.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "hsr/sheet/stroke_font.h"

namespace hsr::internal {

namespace {

constexpr double width = 180, height = 36, row = 9;
constexpr double margin = 1.2;  // of text in a field
constexpr double caption = 1.8, value = 2.5, large = 3.5, largest = 5;

/// A way to write a text: how high its letters are, and where each line of it has its base, from the top of the field.
struct Setting {
  double letters;
  std::vector<double> bases;
};

/// A field: where it is in the block, what it is called, and what it says.
struct Field {
  double x, y, width, height;
  const char* name;
  std::string text;
  std::vector<Setting> settings;  ///< the first in which the text has room counts
};

constexpr double base_line = margin + 0.3;  // above the bottom of a field

/// In one row: at that height, lower, and in two lines of the lowest that ISO 3098 has.
std::vector<Setting> in_a_row(double letters = value) {
  std::vector<Setting> settings = {{letters, {row - base_line}}};
  if (letters > value) settings.push_back({value, {row - base_line}});
  settings.push_back({caption, {row - 3.6, row - 1}});
  return settings;
}

/// In two rows.
std::vector<Setting> of_owner() {
  const double last = 2 * row - base_line;
  return {{large, {last}}, {large, {last - 1.6 * large, last}}, {value, {last - 1.6 * value, last}}};
}
std::vector<Setting> of_title(bool has_subtitle) {
  if (has_subtitle) return {{largest, {10.6}}, {large, {10.6}}, {value, {7.2, 11.2}}};
  return {{largest, {14}}, {largest, {9.2, 16.2}}, {large, {10, 15.6}}};
}
std::vector<Setting> of_subtitle() { return {{large, {2 * row - base_line}}, {value, {2 * row - base_line}}}; }

/// The text in one line, or, where it is too wide for one and may have two, broken at the blank that leaves the least width.
std::vector<std::string> broken(std::string_view text, std::size_t most, const StrokeFont& font, double widest) {
  const double whole = font.width(text);
  if (most < 2 || whole <= widest) return {std::string(text)};
  std::size_t best = std::string_view::npos;
  double least = whole;
  for (std::size_t at = text.find(' '); at != std::string_view::npos; at = text.find(' ', at + 1)) {
    const double wider = std::max(font.width(text.substr(0, at)), font.width(text.substr(at + 1)));
    if (wider < least) {
      least = wider;
      best = at;
    }
  }
  if (best == std::string_view::npos) return {std::string(text)};
  return {std::string(text.substr(0, best)), std::string(text.substr(best + 1))};
}

/// What a field says, and a note where it has to be written narrower than its letters are.
void draw_text(Sketch& sketch, const PaperFrame& block, const Field& f, std::vector<std::string>& notes) {
  if (f.text.empty()) return;
  const double x = block.left + f.x + margin, y = block.top + f.y, widest = f.width - 2 * margin;
  std::vector<std::string> lines;
  const Setting* chosen = nullptr;
  for (const Setting& setting : f.settings) {
    const StrokeFont font(setting.letters);
    chosen = &setting;
    lines = broken(f.text, setting.bases.size(), font, widest);
    if (std::ranges::all_of(lines, [&](const std::string& line) { return font.width(line) <= widest; })) break;
    if (&setting == &f.settings.back())
      notes.push_back("title block: \"" + f.text + "\" is too long for its field and is written narrower");
  }
  const std::size_t unused = chosen->bases.size() - lines.size();
  for (std::size_t k = 0; k < lines.size(); ++k)
    sketch.text("title block", lines[k], chosen->letters, {x, y + chosen->bases[unused + k]}, Anchor::left, Reading::across,
                widest);
}

void draw_field(Sketch& sketch, Sketch::LayerIndex lines, const PaperFrame& block, const Field& f,
                std::vector<std::string>& notes) {
  const double x = block.left + f.x, y = block.top + f.y;
  if (f.name != nullptr) {
    sketch.rectangle(lines, {x, y, x + f.width, y + f.height});
    sketch.text("title block", f.name, caption, {x + margin, y + margin + caption});
  }
  draw_text(sketch, block, f, notes);
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

std::vector<std::string> draw_title_block(Sketch& sketch, const PaperFrame& place, const TitleBlock& t,
                                          const std::string& scale, const std::string& format, ProjectionAngle angle) {
  const auto border = sketch.layer("title block border", continuous_pen(0.7));
  const auto lines = sketch.layer("title block", continuous_pen(0.35));
  sketch.polyline(
      border, std::array<Point2, 3>{{{place.left, place.bottom}, {place.left, place.top}, {place.right, place.top}}}, false);
  const Field fields[] = {
      {0, 0, 45, row, "Creator", t.creator, in_a_row()},
      {45, 0, 45, row, "Approved by", t.approver, in_a_row()},
      {90, 0, 50, row, "Document type", t.document_type, in_a_row()},
      {140, 0, 40, row, "Material", t.material, in_a_row()},
      {0, row, 60, 2 * row, "Legal owner", t.owner, of_owner()},
      {60, row, 120, 2 * row, "Title, supplementary title", t.title, of_title(!t.subtitle.empty())},
      {60, row, 120, 2 * row, nullptr, t.subtitle, of_subtitle()},
      {0, 3 * row, 22, row, "Scale", scale, in_a_row(large)},
      {22, 3 * row, 38, row, "Projection", "", in_a_row()},
      {60, 3 * row, 54, row, "Identification number", t.number, in_a_row(large)},
      {114, 3 * row, 10, row, "Rev.", t.revision, in_a_row(large)},
      {124, 3 * row, 22, row, "Date of issue", t.date, in_a_row()},
      {146, 3 * row, 10, row, "Size", format, in_a_row()},
      {156, 3 * row, 9, row, "Lang.", t.language, in_a_row()},
      {165, 3 * row, 15, row, "Sheet", t.sheet, in_a_row()},
  };
  std::vector<std::string> notes;
  for (const Field& field : fields) draw_field(sketch, lines, place, field, notes);
  draw_projection_symbol(sketch, {place.left + 22 + 12, place.top + 3 * row, place.left + 60, place.bottom}, angle, 0.35);
  return notes;
}

}  // namespace hsr::internal
