#pragma once

#include <string>

#include "study/comparison.h"

namespace hsr::internal {

/// A line for each method and size, under a line of names.
std::string comparison_csv(const Comparison& comparison);

}  // namespace hsr::internal
