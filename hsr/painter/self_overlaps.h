#pragma once

#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// A planar face that crosses itself is cut into triangles that can overlap in its plane (rules F7 and F9). Of two pieces of such
/// a face that do, the one that is painted earlier loses what the later one covers: whatever is painted between them meets the
/// plane nowhere inside both, so that the order stays right, and each place of the face is painted once (rule P14). To be called
/// before wires are put between the pieces.
///
/// Exact: yes. Cost: where no face crosses itself, a look at each face. Else, for each face that does, of the pairs of its pieces
/// those whose boxes meet, a sign for each corner of one and side of the other.
void cut_self_overlaps(const SceneView& scene, PaintersOrder& order);

}  // namespace hsr::internal
