#pragma once

#include <span>
#include <vector>

#include "hsr/drawing/page.h"
#include "hsr/io/write/line_style.h"

namespace hsr::internal {

/// The dashes of a polyline, for formats that have none of their own: they begin with it and run on over its corners, as in SVG.
/// @param points of a closed line, the first again at the end @param style dashed
std::vector<std::vector<PaperPoint>> dashes_of(std::span<const PaperPoint> points, const LineStyle& style);

}  // namespace hsr::internal
