#pragma once

#include "hsr/surfaces/section.h"

namespace hsr::internal {

/// The caps of a view with several sections, or with a far plane: those of each plane, cut off at the sides of its cell. Where those of
/// two planes meet in one object the line is a `joint`. Planes that are seen edge-on have caps that are seen as lines, of which there are
/// some only where nothing else is left of the view beside them: where no other kind of plane is.
/// @pre scene.view().has_cells()
/// Exact: yes. Cost: that of the caps of each plane; rationals for each of their sides.
Section section_in_cells(const SceneView& scene);

}  // namespace hsr::internal
