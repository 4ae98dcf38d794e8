#pragma once

#include <string>

#include "study/stability.h"

namespace hsr::internal {

/// A line for each family, method and value, under a line of names.
std::string stability_csv(const Stability& stability);

}  // namespace hsr::internal
