#pragma once

#include <string>

#include "hsr/cli/page_arguments.h"

namespace hsr::cli {

/// What to say of a drawing that is no more than a dot at the scale that was asked for: its size, and which unit and scale would
/// show it. Empty: it is larger, or the scale was fitted.
/// @param width, height in units of the model
std::string note_on_dot(double width, double height, const PageArguments& page);

}  // namespace hsr::cli
