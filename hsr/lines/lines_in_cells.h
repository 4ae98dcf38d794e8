#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// The visible lines of a view with several sections, or with a far plane: those of each cell, cut off at its sides, as one line wherever
/// they go on. A line along a side of two cells is hidden where it is in one of them.
/// @pre scene.view().has_cells()
/// Exact: yes. Cost: that of the visible lines of each cell.
VisibleLines lines_in_cells(const SceneView& scene, const LineOptions& options);

}  // namespace hsr::internal
