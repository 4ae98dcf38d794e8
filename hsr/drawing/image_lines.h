#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/drawing/end_images.h"
#include "hsr/drawing/projection.h"

namespace hsr::internal {

/// Lines grouped by the straight line of the image that carries them.
struct ImageLines {
  Ragged<std::uint32_t> members;    ///< by group: indices of VisibleLines::lines; ascending in a group, groups by their first
  std::vector<std::uint8_t> steep;  ///< for each member: its line changes y at least as fast as x
};

/// Two are in one group iff both ends of one lie in the view plane of the other.
///
/// `at` has the images of the vertices of the edges on the page.
/// Exact: yes. Candidates are found by slope and intercept (enclosures; rationals where a line is too short on the paper for
/// them), predicates decide, and for where faces pierce each other rationals. Cost: O(n log n).
ImageLines image_lines(const Projection& projection, const EndImages& at, const VisibleLines& lines,
                       std::span<const std::uint32_t> drawn, Predicates& predicates);

}  // namespace hsr::internal
