#pragma once

#include <optional>
#include <string>

namespace hsr::cli {

/// What to say of a drawing that is no more than a dot at the scale that was asked for: its size, and which unit and scale would
/// show it. Empty: it is larger, or the scale was fitted.
/// @param width, height in units of the model @param scale of the page, paper to model; nothing: fitted
/// @param unit millimetres in a unit of the model
std::string note_on_dot(double width, double height, std::optional<double> scale, double unit);

}  // namespace hsr::cli
