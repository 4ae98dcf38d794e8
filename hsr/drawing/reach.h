#pragma once

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Lets each fill reach beneath the opaque ones that are painted later beside it, and never beneath anything else.
///
/// A program that smooths edges covers a pixel between two fills by neither wholly, and what lies under them shines through as a
/// seam. A fill that goes on a little beneath its later neighbours leaves no such pixel: the first that is painted there covers it,
/// the others cover their shares of it, and every border stays where it was.
///
/// Along a side that two fills share the earlier reaches beneath the later, and keeps away from the other sides of that one, where it
/// would show through in turn; but where the two are of nearly one colour, or the later one is thin, it takes all of it. Around a
/// corner where more than two meet, or the later one is wide, the earliest reaches beneath all.
///
/// Cost: O(n log n).
void reach_beneath(Fills& fills);

}  // namespace hsr::internal
