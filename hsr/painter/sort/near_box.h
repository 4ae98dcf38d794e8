#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hsr/painter/sort/overlap.h"

namespace hsr::internal {

/// Around the image of a piece, for certain.
struct NearBox {
  double low_x = 1, high_x = 0, low_y = 1, high_y = 0;

  static NearBox of(const std::vector<NearCorner>& corners) {
    NearBox box = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    const auto add = [](const ErrorBounded& x, double& low, double& high) {
      // A corner whose place is not known may be anywhere; the rest pays for rounding.
      const double reach = x.error < HUGE_VAL ? (x.error + 2 * ErrorBounded::u * std::fabs(x.value)) * 1.01 : HUGE_VAL;
      low = reach < HUGE_VAL ? std::min(low, x.value - reach) : -HUGE_VAL;
      high = reach < HUGE_VAL ? std::max(high, x.value + reach) : HUGE_VAL;
    };
    for (const NearCorner& c : corners) {
      add(c.x, box.low_x, box.high_x);
      add(c.y, box.low_y, box.high_y);
    }
    return box;
  }
  bool is_known() const { return low_x <= high_x; }
  /// Not only at a border.
  bool overlaps(const NearBox& o) const { return high_x > o.low_x && o.high_x > low_x && high_y > o.low_y && o.high_y > low_y; }
};

}  // namespace hsr::internal
