#pragma once

#include <string>

#include "hsr/model.h"

namespace hsr::cli {

/// What --up-axis and --unit are where they are not given: what the format of the model says, else z and millimetres.
///
/// A note says so where it makes a difference, and what speaks for y where the format says nothing.
char up_axis_of(const std::string& option, const Model& model);
std::string up_axis_note(const Model& model);

/// Millimetres in a unit of the model.
double unit_of(const std::string& option, const Model& model);
std::string unit_note(const Model& model);

}  // namespace hsr::cli
