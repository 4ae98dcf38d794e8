#pragma once

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/placement.h"

namespace hsr::internal {

/// Adds the borders and the hatching of caps, which are nearest of all, after the lines that are there.
///
/// Each object is hatched in one direction in all views of it, but that objects that touch are hatched differently.
void add_section_lines(Drawing& drawing, const Placement& placement, const DrawingOptions& options);

/// Adds the faces of caps, after the fills that are there.
void add_section_fills(Fills& fills, const Placement& placement, const DrawingOptions& options);

}  // namespace hsr::internal
