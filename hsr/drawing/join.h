#pragma once

#include <cstdint>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/drawing/page.h"

namespace hsr::internal {

/// A straight line on the paper, its style and its object: only lines of one style and one object are joined.
struct PaperLine {
  PaperPoint from, to;
  std::uint32_t style = 0;
  std::uint32_t object = 0xffffffffU;  ///< SceneObjects::none: of several, or none is told apart
};

/// Lines in a row.
struct Chains {
  Ragged<std::uint32_t> passes;  ///< by chain; 2 k: line k is passed from `from` to `to`; 2 k + 1: from `to` to `from`
  std::vector<char> closed;      ///< for each chain: its end is its start
};

/// Every line in exactly one chain, joined where they meet on the paper: two ends at a point always, of more than two the
/// straightest pairs first. Chains ascend by their lowest line, and start there if closed, else nearer to it.
///
/// The angles are doubles: they choose which lines share a path, never where a line is.
/// @pre no line has its ends at one point. Cost: O(n log n).
Chains join(const std::vector<PaperLine>& lines);

}  // namespace hsr::internal
