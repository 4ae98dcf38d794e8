#pragma once

#include <string>

namespace hsr::internal {

/// Whether a path ends like IGES, with .gz behind or not.
bool is_iges(const std::string& path);

}  // namespace hsr::internal
