#pragma once

#include <cstdint>
#include <string_view>

namespace hsr::internal {

/// A letter as strokes of a pen, in tenths of the height of capitals, y up from the base line.
struct Glyph {
  char32_t code = 0;
  double width = 0;
  /// Strokes with "/" between. A stroke is points "x,y" and arcs "@x,y,rx,ry,from,to": of the ellipse around (x, y), in degrees, counter-
  /// clockwise where `to` is more than `from`. Straight lines lead from each to the next.
  std::string_view strokes = {};
};

/// A letter made of another one and a mark over or under it.
struct AccentedGlyph {
  char32_t code = 0, base = 0, mark = 0;
};

/// nullptr: there is none.
const Glyph* glyph_of(char32_t code);
/// The mark that a code stands for is drawn around x = 0, over a small letter; over capitals it is 3 higher.
const Glyph* mark_glyph(char32_t mark);
/// With code 0: the letter has no mark.
AccentedGlyph accented_glyph(char32_t code);

}  // namespace hsr::internal
