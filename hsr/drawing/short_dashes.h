#pragma once

#include <functional>
#include <vector>

#include "hsr/drawing/join.h"

namespace hsr::internal {

/// Where objects take turns along a dashed line, as two rims do that have their corners on one circle, the line is one of several objects
/// (`PaperLine::object`), so that its dashes run on: else each piece would begin and end with one, and look continuous.
///
/// @param shortest by style: chains shorter than this, in thousandths of a millimetre, have no room for dashes; 0: it is continuous
/// @return whether there were any; `lines` are then to be joined again. Cost: O(n log n) in what is that short.
bool share_short_dashes(std::vector<PaperLine>& lines, const Chains& chains,
                        const std::function<double(std::uint32_t)>& shortest);

}  // namespace hsr::internal
