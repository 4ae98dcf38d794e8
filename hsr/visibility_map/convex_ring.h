#pragma once

#include <vector>

#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The corners of a facet, as its triangles run, if it is convex; empty otherwise. Corners of 180 degrees count as convex.
///
/// Exact: yes; does not depend on the view. Cost: O(n^2) for n triangles of the facet.
std::vector<VertexId> convex_ring(const ProjectedMesh& projected, FacetId facet, Predicates& exact);

}  // namespace hsr::internal
