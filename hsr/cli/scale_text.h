#pragma once

#include <string>

#include "hsr/cli/page_arguments.h"

namespace hsr::cli {

/// The scale of a page as a draughtsman reads it: "scale 1:2 (0.5 mm per unit)" where it was asked for or is a plain ratio, else
/// "scale 3.474 mm per unit"; in perspective it is that at the target.
/// @param mm_per_unit millimetres of paper to a unit of the model @param unit millimetres that this unit is
std::string scale_text(double mm_per_unit, double unit, const PageArguments& page, bool is_perspective);

/// ", scale 1:2" for the title of a page whose scale was chosen; empty where it was fitted.
std::string scale_in_title(const Drawing& drawing, const DrawingOptions& options, const PageArguments& page);

}  // namespace hsr::cli
