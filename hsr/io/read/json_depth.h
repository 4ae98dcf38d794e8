#pragma once

#include <string_view>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

/// Refuses JSON with brackets more than 100 deep. The parsers have no recursion, but what walks over their result, prints it or
/// destroys it may: a short file could end the process.
/// @param text the JSON, in `source` from `first_byte` on
void check_json_depth(const Source& source, std::string_view text, std::size_t first_byte = 0);

}  // namespace hsr::internal::read
