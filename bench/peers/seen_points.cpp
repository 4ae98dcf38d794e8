#include "bench/peers/seen_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace hsr::bench {

std::vector<std::array<double, 3>> seen_points(const Mesh& mesh, const View& view, double size) {
  require(!view.is_perspective(), "seen_points: expected a parallel view");
  const auto dot = [](const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const Frame& f = view.frame;
  const Point3 d = view.viewpoint.at;
  const double length = std::sqrt(dot(d, d));
  std::vector<std::array<double, 3>> points(mesh.points.size());
  std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Point3& p = mesh.points[VertexId(v)];
    points[v] = {dot(p, f.right), dot(p, f.up), dot(p, d) / length};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], points[v][k]);
      high[k] = std::max(high[k], points[v][k]);
    }
  }
  const double scale = size / std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
  for (auto& p : points)
    for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] - low[k]) * scale;
  return points;
}

}  // namespace hsr::bench
