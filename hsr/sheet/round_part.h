#pragma once

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// What of a drawing's lines is inside a circle, cut there to the rounding of the paper; without arcs and fills.
Drawing round_part(const Drawing& drawing, const Point2& centre, double radius);

}  // namespace hsr::internal
