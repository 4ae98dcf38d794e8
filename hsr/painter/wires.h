#pragma once

#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// The wires of the scene among the pieces of an order, cut where a piece passes between what is in front of it and what is behind.
///
///   (1) a part of a wire comes after each piece that it is in front of somewhere, or that it lies on, where their images overlap, and
///       before each that it is behind; touching is no overlap
///   (2) the parts of a wire tile it beyond the near plane, and none needs fewer among these pieces; a wire seen as a point has none
///   (3) each comes as late as (1) allows
///
/// Of wires that cross one another in the image the order says nothing.
/// @pre the order is right
/// Exact: yes, in rationals, as wires are few. Cost: O(n log n), and for k pairs of a wire and a piece whose boxes overlap O(k log k)
/// and the corners of these pieces, parallel.
std::vector<OrderedWire> ordered_wires(const SceneView& scene, const PaintersOrder& order);

/// Each wire that is not seen as a point, whatever of it is beyond the near plane, before the first piece.
std::vector<OrderedWire> whole_wires(const SceneView& scene);

}  // namespace hsr::internal
