#pragma once

#include <functional>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

/// The order of a view with several sections, or with a far plane: those of its cells, one after the other, each piece cut off at the sides of
/// its cell, beyond which nothing of it is seen.
/// @param order_of the order of one cell @pre scene.view().has_cells()
/// Exact: yes. Cost: that of the orders, and some signs for each corner.
PaintersOrder order_in_cells(const SceneView& scene, const std::function<PaintersOrder(const ViewParts::Cell&)>& order_of);

}  // namespace hsr::internal
