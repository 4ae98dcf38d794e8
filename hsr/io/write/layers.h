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

}  // namespace hsr::internal
