#pragma once

#include <vector>

#include "geometry/number.h"

namespace hsr::internal {

/// The double nearest to the exact sum, ties to even.
///
/// The exact sum of many rationals has the product of their denominators; so they are summed as whole multiples of a small
/// power of two first, and exactly only where the bounds of that sum round to two doubles. Exact: yes. Cost: O(n) mostly.
double rounded_sum(const std::vector<const Rational*>& terms);

}  // namespace hsr::internal
