#pragma once

#include <string>

#include "hsr/io/write/json.h"
#include "hsr/surfaces/section.h"

namespace hsr::internal {

/// Appends `, "section": {…}`: the caps, and how many outlines of the cut do not close (docs/conventions.md, J3).
void append_section(std::string& out, const Section& section, Numbers numbers);

}  // namespace hsr::internal
