#pragma once

#include <vector>

#include "hsr/painter/overlap.h"
#include "hsr/painter/painters_order.h"

namespace hsr {

/// All facets that are not seen edge-on, beyond the near plane, as convex pieces; ascending by facet. Cost: O(n), parallel.
std::vector<PieceOfFacet> convex_pieces(const Sight& sight);

/// Appends a piece to an order.
void append(const Mesh& mesh, const PieceOfFacet& piece, PaintersOrder& order);

}  // namespace hsr
