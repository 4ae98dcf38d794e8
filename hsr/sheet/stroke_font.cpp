#include "hsr/sheet/stroke_font.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "hsr/sheet/glyphs.h"
#include "hsr/utf8.h"

namespace hsr::internal {

namespace {

constexpr double gap = 2;        // between letters, tenths of the height
constexpr double arc_step = 18;  // degrees: letters are a few millimetres high
constexpr double raised = 3;     // marks of capitals

constexpr Glyph unknown = {0, 5.4, "0,0 0,10 5.4,10 5.4,0 0,0"};

/// A letter with where it stands, in tenths of the height.
struct PlacedGlyph {
  const Glyph* glyph;
  double x, y;
};

/// Walks over the letters of a text. @returns how wide it is, in tenths of the height
template <class OnGlyph>
double lay_out(std::string_view text, const OnGlyph& on_glyph) {
  double x = 0;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character letter = utf8_character(text, i);
    i += letter.bytes > 0 ? letter.bytes : 1;
    const AccentedGlyph accent = accented_glyph(letter.bytes > 0 ? letter.code : 0);
    const char32_t base = accent.code != 0 ? accent.base : letter.bytes > 0 ? letter.code : 0;
    const Glyph* glyph = glyph_of(base);
    if (glyph == nullptr) glyph = &unknown;
    on_glyph(PlacedGlyph{glyph, x, 0});
    if (accent.code != 0) {
      const bool is_over = accent.mark != U',' && accent.mark != U';';
      on_glyph(PlacedGlyph{mark_glyph(accent.mark), x + glyph->width / 2, is_over && base < U'a' ? raised : 0});
    }
    x += glyph->width + gap;
  }
  return x > 0 ? x - gap : 0;
}

/// Numbers with commas between, up to a blank.
std::vector<double> numbers_of(std::string_view& rest) {
  std::vector<double> numbers;
  for (;;) {
    double x = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), x);
    numbers.push_back(x);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (rest.empty() || rest.front() != ',') return numbers;
    rest.remove_prefix(1);
  }
}

void add_arc(TextStroke& stroke, const std::vector<double>& a) {
  const double from = a[4], to = a[5];
  const int steps = static_cast<int>(std::ceil(std::fabs(to - from) / arc_step));
  for (int k = 0; k <= steps; ++k) {
    const double t = (from + (to - from) * k / steps) * std::numbers::pi / 180;
    stroke.push_back({a[0] + a[2] * std::cos(t), a[1] + a[3] * std::sin(t)});
  }
}

/// In tenths of the height, y up.
std::vector<TextStroke> strokes_of(std::string_view rest) {
  std::vector<TextStroke> strokes;
  TextStroke stroke;
  while (!rest.empty()) {
    const char c = rest.front();
    if (c == ' ' || c == '/' || c == '@') rest.remove_prefix(1);
    if (c == ' ') continue;
    if (c == '/') {
      strokes.push_back(std::move(stroke));
      stroke.clear();
    } else if (c == '@') {
      add_arc(stroke, numbers_of(rest));
    } else {
      const std::vector<double> p = numbers_of(rest);
      stroke.push_back({p[0], p[1]});
    }
  }
  if (!stroke.empty()) strokes.push_back(std::move(stroke));
  return strokes;
}

}  // namespace

double StrokeFont::width(std::string_view text) const {
  return unit_ * lay_out(text, [](const PlacedGlyph&) {});
}

std::vector<TextStroke> StrokeFont::strokes(std::string_view text, const Point2& origin) const {
  std::vector<TextStroke> all;
  lay_out(text, [&](const PlacedGlyph& placed) {
    for (TextStroke& stroke : strokes_of(placed.glyph->strokes)) {
      for (Point2& p : stroke) p = {origin.x + unit_ * (placed.x + p.x), origin.y - unit_ * (placed.y + p.y)};
      all.push_back(std::move(stroke));
    }
  });
  return all;
}

bool StrokeFont::knows(std::string_view text) {
  bool knows_all = true;
  lay_out(text, [&](const PlacedGlyph& placed) { knows_all = knows_all && placed.glyph != &unknown; });
  return knows_all;
}

}  // namespace hsr::internal
