#pragma once

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/placement.h"

namespace hsr::internal {

/// Regions on the page, corner by corner, each coordinate the exact one rounded to 0.001 mm; with a frame cut to it.
Fills placed_fills(const Placement& placement, const Regions& regions);

}  // namespace hsr::internal
