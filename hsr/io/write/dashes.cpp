#include "hsr/io/write/dashes.h"

#include <cmath>

namespace hsr::internal {

std::vector<std::vector<PaperPoint>> dashes_of(std::span<const PaperPoint> points, const LineStyle& style) {
  std::vector<std::vector<PaperPoint>> dashes;
  bool is_down = true;
  double left = style.dash * 1000;  // of the dash or the gap at hand
  if (!points.empty()) dashes.push_back({points.front()});
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const PaperPoint &a = points[k], &b = points[k + 1];
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y), length = std::hypot(dx, dy);
    double done = 0;
    while (length - done > left) {
      done += left;
      const PaperPoint at = {a.x + std::llround(dx * done / length), a.y + std::llround(dy * done / length)};
      if (is_down)
        dashes.back().push_back(at);
      else
        dashes.push_back({at});
      is_down = !is_down;
      left = (is_down ? style.dash : style.gap) * 1000;
    }
    left -= length - done;
    if (is_down) dashes.back().push_back(b);
  }
  return dashes;
}

}  // namespace hsr::internal
