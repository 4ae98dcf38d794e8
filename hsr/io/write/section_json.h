#pragma once

#include <string>

#include "hsr/io/write/json.h"
#include "hsr/surfaces/section.h"

namespace hsr::internal {

/// Appends `, "section": {…}`: the caps, and how many outlines of the cut do not close (docs/conventions.md, J3).
/// @param has_planes the view has several: each cap says which is its own
void append_section(std::string& out, const Section& section, Numbers numbers, bool has_planes = false);

}  // namespace hsr::internal
