#pragma once

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Pens by ISO 128: what can be seen in 0.5 mm, continuous (01.2); what cannot in 0.25 mm, dashed (02.1: dashes of 12 widths,
/// gaps of 3); smooth edges, which a draughtsman calls imaginary, and
/// joints, thin and continuous (01.1).
struct LineStyle {
  double width = 0.5;
  double dash = 0, gap = 0;  ///< mm; 0: continuous

  /// Dashes end square, so that they have the length that they should; continuous lines round.
  bool is_dashed() const { return dash > 0; }
};

inline LineStyle line_style(bool hidden, EdgeClass edge_class, HiddenLines hidden_lines) {
  if (hidden) return hidden_lines == HiddenLines::solid ? LineStyle{0.25, 0, 0} : LineStyle{0.25, 3, 0.75};
  const bool is_thin = edge_class == EdgeClass::smooth || edge_class == EdgeClass::joint;
  return {is_thin ? 0.25 : 0.5, 0, 0};
}

}  // namespace hsr::internal
