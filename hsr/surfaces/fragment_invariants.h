#pragma once

#include "hsr/scene/projected_mesh.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::internal {

/// What fragments promise, looked at once more: by every result where the build checks its invariants (HSR_CHECKS).
///
/// Every ring turns the right way; no two sides cross, touch within a ring, or run along one another the same way; no middle of
/// a side is inside another fragment; holes are inside. So rings are simple, and fragments do not overlap. Of at most 12
/// triangles, none of them cut by the near plane, the areas of all fragments add up to that of the union of the triangles as
/// seen. Results of more than 5000 corners are passed over.
/// @throws InvariantError
/// Exact: yes. Cost: O(n log n + k) for k pairs of sides, or of sides and fragments, whose boxes touch; rationals.
void check_invariants(const ProjectedMesh& projected, const VisibleFragments& fragments);

}  // namespace hsr::internal
