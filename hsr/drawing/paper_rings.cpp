#include "hsr/drawing/paper_rings.h"

#include <algorithm>
#include <cmath>

namespace hsr::internal {

std::vector<PaperPoint> clipped(std::vector<std::array<Enclosure::Wide, 2>> ring, const PaperFrame& frame) {
  using Wide = Enclosure::Wide;
  const std::array<Wide, 4> bound = {frame.left, -frame.right, frame.top, -frame.bottom};
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t axis = side / 2;
    const Wide sign = side % 2 == 0 ? 1 : -1;
    const auto inside = [&](const std::array<Wide, 2>& p) { return sign * p[axis] - bound[side]; };
    std::vector<std::array<Wide, 2>> out;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto &p = ring[k], &q = ring[(k + 1) % ring.size()];
      const Wide a = inside(p), b = inside(q);
      if (a >= 0) out.push_back(p);
      if ((a < 0) != (b < 0)) {
        const Wide t = a / (a - b);
        out.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
      }
    }
    ring = std::move(out);
  }
  std::vector<PaperPoint> points;
  points.reserve(ring.size());
  for (const auto& p : ring)
    points.push_back({static_cast<std::int64_t>(std::round(p[0] * 1000)), static_cast<std::int64_t>(std::round(p[1] * 1000))});
  return points;
}

void drop_repeated(std::vector<PaperPoint>& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() < 3) ring.clear();
}

}  // namespace hsr::internal
