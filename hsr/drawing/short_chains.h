#pragma once

#include <cstdint>
#include <vector>

#include "hsr/drawing/join.h"

namespace hsr::internal {

/// Which chains belong to short groups: chains that have a point of the paper in common are of one group, and its length is that of
/// all of them. So a freckle on a scan is short, and the short side of a long outline is not.
/// @param least thousandths of a millimetre @return by chain: 1 if its group is shorter. Cost: O(n log n).
std::vector<std::uint8_t> in_short_groups(const std::vector<PaperLine>& lines, const Chains& chains, double least);

}  // namespace hsr::internal
