#pragma once

#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::internal {

/// The visible fragments of a view with several sections, or with a far plane: those of each cell, cut off at its sides, and united
/// wherever a facet goes on beyond them.
/// @pre scene.view().has_cells()
/// Exact: yes. Cost: that of the fragments of each cell.
VisibleFragments fragments_in_cells(const SceneView& scene, const FragmentOptions& options);

}  // namespace hsr::internal
