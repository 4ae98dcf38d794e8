#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hsr/drawing/join.h"

namespace hsr::internal {

/// Thousandths of a millimetre: what is shorter is not drawn, nor what is at most this far from a stronger line all along.
inline constexpr std::int64_t least_on_paper = 10;

/// What is left of some lines.
struct DistinctLines {
  std::vector<PaperLine> lines;                          ///< in the order of those they are parts of
  std::vector<std::uint32_t> part_of;                    ///< for each: the line it is, or is a part of
  std::vector<std::array<std::uint32_t, 2>> stands_for;  ///< [line that is left, line left out near it], ascending
  std::uint64_t near_coincident = 0;                     ///< lines left out, wholly or in part
};

/// The lines without the parts that run beside a stronger line at no more than least_on_paper: visible before hidden, then
/// class before class, then the longer chain before the shorter, then the earlier.
///
///   (1) every point left out is that near to a line that is left, but for half a unit of rounding; so there are no gaps
///   (2) two lines only count if they run in roughly one direction (a slope of 1 in 8) and beside each other for more than
///       least_on_paper, and of a chain runs of 100 times that, or all of it: what crosses or continues a line stays, and so do
///       the outlines of fine meshes
///   (3) of two lines that part where they meet, at a common end, nothing is left out
///   (4) a line of which nothing is left out is as it was
///
/// This looks at the written coordinates only, in integers. @pre styles are those of drawing.cpp: the class, + 16 if visible.
/// Cost: O(n log n) for lines spread over the page.
DistinctLines without_near(const std::vector<PaperLine>& lines, const Chains& chains);

}  // namespace hsr::internal
