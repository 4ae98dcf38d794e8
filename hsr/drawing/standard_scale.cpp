#include "hsr/drawing/standard_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hsr::internal {

double standard_scale(long double most) {
  most *= 1 + 1e-12L;  // what is exactly as large as the page fits, whatever the last bit says
  const int exponent = std::clamp(static_cast<int>(std::floor(std::log10(most))) + 1, -300, 300);
  for (int e = exponent;; --e)
    for (const double first : {5.0, 2.0, 1.0}) {
      const double power = std::pow(10.0, std::abs(e));
      const double scale = e >= 0 ? first * power : 1 / (first == 1 ? power : power / first);  // 2 of 10: 1:5
      if (scale <= most || e <= -300) return scale;
    }
}

}  // namespace hsr::internal
