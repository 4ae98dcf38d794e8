#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/page.h"

namespace hsr::internal {

/// Which part of the way from one point to another is inside a box, in shares; nothing: none is.
inline std::optional<std::array<double, 2>> part_within(const PaperFrame& box, const Point2& from, const Point2& to) {
  double enters = 0, leaves = 1;
  for (const auto& [at, along, low, high] :
       {std::tuple{from.x, to.x - from.x, box.left, box.right}, std::tuple{from.y, to.y - from.y, box.top, box.bottom}}) {
    if (along == 0 && !(at > low && at < high)) return {};
    if (along == 0) continue;
    const double s = (low - at) / along, t = (high - at) / along;
    enters = std::max(enters, std::min(s, t));
    leaves = std::min(leaves, std::max(s, t));
  }
  if (!(enters < leaves)) return {};
  return std::array{enters, leaves};
}

/// Whether no line of the layers of one view runs through a box.
inline bool is_free(const Drawing& drawing, const std::string& view, const PaperFrame& box) {
  const auto mm = [](const PaperPoint& p) { return Point2{static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000}; };
  for (const NamedLayer& layer : drawing.layers) {
    if (!layer.name.starts_with(view + " ")) continue;
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
      const Polyline& p = drawing.polylines[k];
      const auto points = drawing.points_of(p);
      for (std::size_t i = 0; i + 1 < points.size() + (p.closed ? 1 : 0); ++i)
        if (part_within(box, mm(points[i]), mm(points[(i + 1) % points.size()]))) return false;
    }
  }
  return true;
}

}  // namespace hsr::internal
