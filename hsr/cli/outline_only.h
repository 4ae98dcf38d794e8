#pragma once

#include "hsr/drawing/drawing.h"
#include "hsr/lines/line_options.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::cli {

/// Options for the outline of everything alone: the page is as large as all that has an outline.
void ask_for_outline_only(LineOptions& lines, DrawingOptions& drawing);

/// What all faces cover together, for draw() with that option.
/// @throws InputError of a view with a section
Regions union_of_all(const SceneView& scene, const VisibleFragments& fragments);

}  // namespace hsr::cli
