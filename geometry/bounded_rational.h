#pragma once

#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/number.h"

namespace hsr::internal {

/// A double with a bound of what it is off, found sooner than the nearest one.
inline ErrorBounded bounded(const Rational& x) {
  const double d = mpq_get_d(x.get());  // truncated: off by less than one unit in its last place
  return {d, std::isfinite(d) ? 2 * ErrorBounded::u * std::fabs(d) + 0x1p-1074 : HUGE_VAL};
}

}  // namespace hsr::internal
