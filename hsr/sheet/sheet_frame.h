#pragma once

#include "hsr/sheet/sheet.h"
#include "hsr/sheet/sketch.h"

namespace hsr::internal {

/// The frame of a sheet, its four centring marks, and around it the grid of fields 50 mm wide by which places are named: letters
/// downwards, without I and O, and numbers to the right (ISO 5457).
void draw_frame(Sketch& sketch, const SheetFormat& format);

}  // namespace hsr::internal
