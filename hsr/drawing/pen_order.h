#pragma once

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Millimetres of a drawing's polylines, and of the ways between them with the pen up, from the upper left corner of the page on.
struct PenTravel {
  double down = 0, up = 0;
};
PenTravel pen_travel(const Drawing& drawing);

/// Puts the polylines of each layer, and in it of each object, into an order for short ways with the pen up, turned around where that
/// is shorter, closed ones begun at any of their points. One that begins where the one before ends is the same polyline then.
///
///   (1) what is drawn stays the same, stretch by stretch
///   (2) layers and objects stay in their order
///
/// First the nearest of those that are left, again and again, then what shorten() finds. The same for any number of threads.
/// Cost: O(n log n) where lines are spread; see pen_tour.h.
/// @returns for each point of the drawing the one at which the line from it began, or ended, before; of the last point of an open
/// polyline any. @pre no arcs yet
std::vector<std::uint32_t> sort_for_pen(Drawing& drawing);

}  // namespace hsr::internal
