#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// Lets pieces of one face lie over one another a little where a cut parted them.
///
/// Cuts run along the borders of what is painted between the two parts: in a pixel there, some of it would show between them. So the
/// later part also covers a little of the earlier one along the cut, in the same colour; but not where something that is painted
/// between the two lies.
///
/// @param rings convex, in the order in which they are painted; corners are added where one covers more than it was
/// @param facets by ring: pieces of one facet are of one colour
/// Cost: O(n log n), and for each cut a look at what is painted there.
void close_cuts(std::vector<std::vector<PaperPoint>>& rings, std::span<const std::uint32_t> facets);

}  // namespace hsr::internal
