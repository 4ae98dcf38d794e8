#pragma once

#include <string>

#include "hsr/cli/model_file.h"

namespace hsr::cli {

/// What is on the standard input.
/// @param format "obj" or another ending; empty: by content
/// @throws InputError in one line that begins with "standard input"
ModelFile read_standard_input(const std::string& format);

}  // namespace hsr::cli
