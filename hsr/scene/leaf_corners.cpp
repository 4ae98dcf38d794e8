#include "hsr/scene/leaf_corners.h"

#include <algorithm>

#include "geometry/vector3.h"

namespace hsr::internal {

LeafCorners::LeafCorners(const ProjectedMesh& projected, std::span<const TriangleId> triangles) {
  const auto& mesh = projected.mesh();
  Point3 low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const TriangleId t : triangles)
    for (const VertexId v : mesh.triangles[t]) {
      const Point3& p = projected.point(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  middle_ = {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2};
  double reach = 0;
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point3 way = minus(projected.point(mesh.triangles[triangles[k]][corner]), middle_);
      ways_[corner][0][k] = static_cast<float>(way.x);
      ways_[corner][1][k] = static_cast<float>(way.y);
      ways_[corner][2][k] = static_cast<float>(way.z);
      reach = std::max(reach, norm_one(way));
    }
  reach_ = reach < 0x1p100 ? reach * 1.01 : HUGE_VAL;
}

}  // namespace hsr::internal
