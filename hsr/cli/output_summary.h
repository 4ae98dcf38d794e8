#pragma once

#include <cstdint>
#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::cli {

/// "no lines", "1 line", "1234 lines": how many there are of what `one` is a word for.
std::string counted(std::uint64_t count, const std::string& one);

/// "210 x 297 mm"
std::string paper_size(double width, double height);

/// "1:1 in units of the model (m), 12.5 x 8 units": of a drawing in units of the frame. @param unit millimetres that a unit is
std::string model_size(const Drawing& drawing, double unit);

/// "1240 x 1754 pixels", from what the file itself says.
/// @pre `png` holds a PNG file
std::string pixel_size(const std::string& png);

}  // namespace hsr::cli
