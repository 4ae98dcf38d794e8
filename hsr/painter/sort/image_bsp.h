#pragma once

#include <functional>
#include <span>
#include <vector>

#include "hsr/painter/sort/overlap.h"

namespace hsr::internal {

/// Orders pieces from far to near by the planes of some of them, cutting what a plane passes through: always possible. For the
/// pieces that are in cycles; bsp.h has the tree that is kept.
///
/// @param before_cut is called before each cut, and may throw
/// Exact: yes. Deterministic. Cost: O(n log n) where the planes divide well, O(n^2) pieces at worst. Never recursive.
/// Source: Fuchs, Kedem & Naylor 1980.
std::vector<PieceOfFacet> ordered_by_planes(MapPredicates& map, std::vector<PieceOfFacet> pieces,
                                            const std::function<void()>& before_cut);

}  // namespace hsr::internal
