#pragma once

#include "geometry/index.h"
#include "geometry/point.h"

namespace hsr::internal {

/// For each point the lowest index of a point equal to it. @pre finite, no -0. Cost: O(n) expected.
IndexedVector<VertexId, VertexId> merge_points(const IndexedVector<VertexId, Point3>& points);

}  // namespace hsr::internal
