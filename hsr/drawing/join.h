#pragma once

#include <cstdint>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr {

/// A straight line on the paper, and its style: only lines of one style are joined.
struct PaperLine {
  PaperPoint from, to;
  std::uint32_t style = 0;
};

/// Lines of one style in a row; `reversed[k]`: line k is passed from `to` to `from`.
struct Chain {
  std::vector<std::uint32_t> lines;
  std::vector<bool> reversed;
  bool closed = false;
};

/// Every line in exactly one chain, joined where they meet on the paper: two ends at a point always, of more than two the
/// straightest pairs first. Chains ascend by their lowest line, and start there if closed, else nearer to it.
///
/// The angles are doubles: they choose which lines share a path, never where a line is.
/// @pre no line has its ends at one point. Cost: O(n log n).
std::vector<Chain> join(const std::vector<PaperLine>& lines);

}  // namespace hsr
