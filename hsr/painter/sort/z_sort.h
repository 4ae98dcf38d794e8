#pragma once

#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// By which point of a face it is sorted.
enum class DepthKey : unsigned char { centroid, farthest_vertex };

/// What most software does: whole faces sorted by the depth of one point of each, in doubles. The order may be wrong: `hsr
/// verify` shows where.
///
/// The farthest comes first; of equally far ones the one on top last (TieRule). Convex faces are one piece, others their triangles.
/// Exact: no. Cost: O(n log n).
PaintersOrder z_sort(const SceneView& scene, DepthKey key);
/// Of a scene that nothing else looks at.
inline PaintersOrder z_sort(const Mesh& mesh, const View& view, DepthKey key) { return z_sort(SceneView(mesh, view), key); }

}  // namespace hsr::internal
