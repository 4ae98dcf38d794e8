#pragma once

#include "geometry/index.h"
#include "geometry/point.h"

namespace hsr::internal {

/// For each point the lowest index of a point equal to it. @pre finite, no -0. Cost: O(n) expected.
IndexedVector<VertexId, VertexId> merge_points(const IndexedVector<VertexId, Point3>& points);

/// Joins clusters: of points that steps of at most `tolerance` connect, the lowest index stands for all.
/// @param merged what merge_points() says of the points; changed
/// @throws InputError if a cluster is wider than twice the tolerance: it is no noise
/// Exact: distances are doubles. Cost: O(n) expected, for clusters of few points.
void merge_clusters(const IndexedVector<VertexId, Point3>& points, double tolerance, IndexedVector<VertexId, VertexId>& merged);

}  // namespace hsr::internal
