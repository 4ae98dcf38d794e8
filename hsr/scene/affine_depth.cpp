#include "hsr/scene/affine_depth.h"

#include <algorithm>

namespace hsr::internal {

AffineDepth affine_depth(const DepthCorners& corners, double reach_x, double reach_y) {
  constexpr double u = ErrorBounded::u;
  const auto& [image, image_error, low, high] = corners;
  std::array<double, 3> middle, x, y;
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = (low[k] + high[k]) / 2;
    x[k] = image[k].x - image[0].x;
    y[k] = image[k].y - image[0].y;
  }
  AffineDepth n;
  n.p = image[0];
  n.value = middle[0];
  n.farthest = std::min({low[0], low[1], low[2]});
  n.nearest = std::max({high[0], high[1], high[2]});
  const double det = x[1] * y[2] - x[2] * y[1], b = middle[1] - middle[0], d = middle[2] - middle[0];
  n.dx = (b * y[2] - d * y[1]) / det;
  n.dy = (x[1] * d - x[2] * b) / det;
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k)
    most = std::max(most, std::fabs(middle[k] - (n.value + n.dx * x[k] + n.dy * y[k])) + (high[k] - low[k]));
  const double error = 2 * image_error;
  n.error = (most + std::fabs(n.dx) * (error + 16 * u * reach_x) + std::fabs(n.dy) * (error + 16 * u * reach_y) +
             16 * u * std::fabs(n.value)) *
                1.01 +
            0x1p-120;
  if (!(n.error < HUGE_VAL)) n = {n.p, 0, 0, 0, HUGE_VAL, n.farthest, n.nearest};
  return n;
}

}  // namespace hsr::internal
