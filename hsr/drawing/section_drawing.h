#pragma once

#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/placement.h"

namespace hsr::internal {

/// Each object has the style (see hatch_for()) that its number asks for, or the next that no earlier object that it touches has.
ObjectHatching hatching_of(const std::vector<const Section*>& sections);

/// Adds the borders and the hatching of caps, which are nearest of all, after the lines that are there.
///
/// Each object is hatched in one direction and at one spacing in all views of it, but that objects that touch are hatched differently.
void add_section_lines(Drawing& drawing, const Placement& placement, const DrawingOptions& options);

/// Adds the faces of caps, after the fills that are there.
void add_section_fills(Fills& fills, const Placement& placement, const DrawingOptions& options);

}  // namespace hsr::internal
