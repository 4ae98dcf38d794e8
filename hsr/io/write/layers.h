#pragma once

#include <span>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/io/write/line_style.h"

namespace hsr::internal {

/// What a drawing has in one style: its lines of one visibility and one class.
struct Layer {
  bool hidden = false;
  EdgeClass edge_class = EdgeClass::outline;
  LineStyle style = {};
  std::span<const Polyline> polylines = {};

  /// "visible outline", with another character between the words where a format wants one.
  std::string name(char between = ' ') const;
};

/// The layers that occur, in the order in which they are drawn: hidden ones first, then by class. Every writer walks over these
/// and decides nothing itself; fills lie under all of them.
std::vector<Layer> layers_of(const Drawing& drawing);

/// What a line between fills is drawn with.
inline LineStyle style_of(const FillLine& line) { return line_style(false, line.edge_class, HiddenLines::none); }

/// Walks over fills and the lines between them as they are painted.
template <class OnFill, class OnLine>
void for_each_painted(const Fills& fills, const OnFill& on_fill, const OnLine& on_line) {
  auto line = fills.lines.begin();
  for (std::uint32_t i = 0; i < fills.fills.size(); ++i) {
    on_fill(fills.fills[i]);
    for (; line != fills.lines.end() && line->after == i; ++line) on_line(*line);
  }
}

}  // namespace hsr::internal
