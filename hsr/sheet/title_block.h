#pragma once

#include <string>
#include <vector>

#include "hsr/sheet/sheet.h"
#include "hsr/sheet/sketch.h"

namespace hsr::internal {

/// The title block: 180 mm wide, in the lower right corner of the frame.
///
/// A text that is too long for its field is written in smaller letters or in two lines, and if that does not do narrower.
/// @param scale "1:2" @param format "A3" @return a note for each that is written narrower
std::vector<std::string> draw_title_block(Sketch& sketch, const PaperFrame& place, const TitleBlock& fields,
                                          const std::string& scale, const std::string& format, ProjectionAngle angle);

/// Where it is on a sheet with that frame.
PaperFrame title_block_place(const PaperFrame& frame);

}  // namespace hsr::internal
