#pragma once

#include <stop_token>

#include "geometry/error.h"

namespace hsr::internal {

/// @throws CancelledError if a stop is asked for
inline void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw CancelledError("cancelled");
}

}  // namespace hsr::internal
