#pragma once

#include <string>

#include "hsr/model.h"

namespace hsr::cli {

/// The model on the standard input.
/// @param format "obj" or another ending; empty: by content
/// @throws InputError in one line that begins with "standard input"
Model read_standard_input(const std::string& format);

}  // namespace hsr::cli
