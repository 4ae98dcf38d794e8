#include "bench/views.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace hsr::bench {

View view_of(const std::string& name, const Mesh& mesh) {
  const Point3 oblique = {1, -0.83, 0.61}, up = {0, 0, 1}, target = centre(mesh);
  if (name == "oblique") return parallel_view(oblique, up, target);
  if (name == "elevation") return parallel_view({0, -1, 0}, up, target);
  if (name != "perspective") throw InputError("view '" + name + "': expected oblique, elevation or perspective");
  Point3 half;  // of the box
  for (const Point3& p : mesh.points)
    half = {std::max(half.x, std::fabs(p.x - target.x)), std::max(half.y, std::fabs(p.y - target.y)),
            std::max(half.z, std::fabs(p.z - target.z))};
  const double step = 4 * std::hypot(half.x, half.y, half.z) / std::hypot(oblique.x, oblique.y, oblique.z);
  return perspective_view({target.x + step * oblique.x, target.y + step * oblique.y, target.z + step * oblique.z}, target, up);
}

}  // namespace hsr::bench
