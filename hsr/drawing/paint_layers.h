#pragma once

#include <cstdint>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// Two convex polygons have more in common than corners are rounded by.
bool overlap(const std::vector<PaperPoint>& p, const std::vector<PaperPoint>& q);

/// For each convex polygon, painted one after the other, the layer that it lies in: one more than the highest of those before it
/// that it overlaps. Polygons of one layer do not overlap, so layer by layer they may be painted in any order, and the picture is
/// the same. What overlaps by less than corners are rounded by does not count.
///
/// Cost: O(n log n) and the pairs whose boxes touch.
std::vector<std::uint32_t> paint_layers(const std::vector<std::vector<PaperPoint>>& polygons);

}  // namespace hsr::internal
