#pragma once

#include <string_view>

namespace hsr::internal {

/// A file of study/pages, which the build puts into the program: "player.js".
/// @throws InvariantError for a name that is not there
std::string_view page_text(std::string_view name);

}  // namespace hsr::internal
