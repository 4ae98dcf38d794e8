#pragma once

#include <vector>

#include "hsr/scene/scene.h"
#include "hsr/surfaces/section.h"

namespace hsr::internal {

/// The caps of section planes that are seen edge-on, as the lines that they are seen as: where faces are cut there, of class section, each
/// place of the image once, for the lowest object that is cut there. None where there are other planes, too: in a half section
/// the border of the cut half is no edge of the body, and has no line.
/// @pre scene.view().has_cells()
std::vector<SectionLine> edge_on_cap_lines(const SceneView& scene);

}  // namespace hsr::internal
