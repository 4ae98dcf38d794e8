#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// The lines of a drawing as HP-GL for pen plotters: 40 units to the millimetre, the origin in the page's lower left corner, one pen
/// for each visibility and class that occurs, from 1 on, hidden ones first. Dashes are drawn one by one. No fills, no widths.
std::string hpgl(const Drawing& drawing);

}  // namespace hsr::internal
