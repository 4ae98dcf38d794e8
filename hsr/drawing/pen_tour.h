#pragma once

#include <cstdint>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// A line that a pen draws in one go, from either end.
struct PenStroke {
  PaperPoint ends[2];
};

/// The strokes in the order in which they are drawn; 2 k: stroke k from its first end to its second, 2 k + 1: the other way.
using PenTour = std::vector<std::uint32_t>;

/// The length of the ways with the pen up, micrometres, from `start` on.
double pen_up(const std::vector<PenStroke>& strokes, const PenTour& tour, const PaperPoint& start);

/// Shortens the ways with the pen up: by 2-opt (Croes 1958), which turns a run of strokes around, and by Or-opt (Or 1976), which moves
/// up to three of them elsewhere, each where that brings an end to one of the eight nearest others; until nothing of this helps.
///
/// The same for the same strokes and tour. Cost: O(n log n) for the neighbours; moves are tried a bounded number of times for each
/// stroke, and of long tours no run longer than 25 million strokes / n is moved.
/// @param tour has each stroke once @param start where the pen is before
void shorten(const std::vector<PenStroke>& strokes, PenTour& tour, const PaperPoint& start);

}  // namespace hsr::internal
