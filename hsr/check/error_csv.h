#pragma once

#include <span>
#include <string>

#include "hsr/check/error_against_time.h"

namespace hsr::internal {

/// Error against run time as comma-separated values, a line for each method and size, under a line of names. Areas as shares of
/// the visible area, wrong samples as shares of the covered ones.
std::string error_csv(std::span<const ErrorAgainstTime> rows);

}  // namespace hsr::internal
