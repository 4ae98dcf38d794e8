#pragma once

#include "hsr/painter/painters_order.h"

namespace hsr {

/// By which point of a face it is sorted.
enum class DepthKey : unsigned char { centroid, farthest_vertex };

/// What most software does: whole faces sorted by the depth of one point of each, in doubles. The order may be wrong: `hsr
/// verify` shows where.
///
/// The farthest comes first; of equally far ones the higher face. Convex faces are one piece, others their triangles.
/// Exact: no. Cost: O(n log n).
PaintersOrder z_sort(const Mesh& mesh, const View& view, DepthKey key);

}  // namespace hsr
