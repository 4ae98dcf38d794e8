#include "hsr/raster/importance_culling.h"

#include <algorithm>
#include <cmath>

#include "hsr/raster/drawn_triangles.h"

namespace hsr::internal {

ImportanceCulled importance_culled(const Mesh& mesh, const View& view, const SampleGrid& samples, double size,
                                   CullingObserver* observer) {
  ImportanceCulled result;
  const DrawnTriangles<double> triangles(mesh, view, samples);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    double area = 0, largest = 0;
    bool is_small = true;
    triangles.visit(TriangleId(k), [&](const auto& a, const auto& b, const auto& c) {
      const auto [left, right] = std::minmax({a.x, b.x, c.x});
      const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
      largest = std::max({largest, right - left, bottom - top});
      is_small = is_small && right - left < size && bottom - top < size;
      area += std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    });
    ++result.tests;
    if (observer != nullptr) observer->tested({k, k + 1, is_small, largest});
    if (!is_small) {
      result.kept.push_back(TriangleId(k));
      continue;
    }
    ++result.culled;
    result.lost_area += area;
  }
  return result;
}

}  // namespace hsr::internal
