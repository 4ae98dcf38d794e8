#pragma once

#include <cstdint>
#include <string>

#include "hsr/cli/page_arguments.h"

namespace hsr::cli {

/// "no lines", "1 line", "1234 lines": how many there are of what `one` is a word for.
std::string counted(std::uint64_t count, const std::string& one);

/// "210 x 297 mm"
std::string paper_size(double width, double height);

/// "1:1 in units of the model (m), 12.5 x 8 units": of a drawing in units of the frame. @param unit millimetres that a unit is
std::string model_size(const Drawing& drawing, double unit);

/// The scale of a page as a draughtsman reads it: "scale 1:2 (0.5 mm per unit)" where it was asked for or is a plain ratio, else
/// "scale 3.474 mm per unit"; in perspective it is that at the target.
/// @param mm_per_unit millimetres of paper to a unit of the model @param unit millimetres that this unit is
std::string scale_text(double mm_per_unit, double unit, const PageArguments& page, bool is_perspective);

/// "1240 x 1754 pixels", from what the file itself says.
/// @pre `png` holds a PNG file
std::string pixel_size(const std::string& png);

}  // namespace hsr::cli
