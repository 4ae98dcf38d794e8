#pragma once

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Lets each fill reach beneath the opaque ones that are painted later beside it, and never beneath anything else.
///
/// A program that smooths edges covers a pixel between two fills by neither wholly, and what lies under them shines through as a
/// seam. A fill that goes on beneath its later neighbours leaves no such pixel: the first that is painted there covers it, the
/// others cover their shares of it, and every border stays where it was.
///
/// Along a side that two fills share the earlier reaches beneath the later; where more than two meet at a corner the earliest
/// reaches beneath all. The whole neighbour is taken, as its corners are there already.
///
/// Cost: O(n log n) in corners where the later one of two neighbours has few corners; see by_corners().
void reach_beneath(Fills& fills);

/// Puts fills that do not overlap into an order to paint: those of one object together, and the ones with many corners first, so
/// that no fill has to reach beneath a neighbour with more corners than it has itself. Then all of them together reach beneath
/// O(n) corners, as in any planar graph (Chiba and Nishizeki 1985).
void sort_by_corners(Fills& fills);

}  // namespace hsr::internal
