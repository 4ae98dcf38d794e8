#include "hsr/drawing/shading.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"

namespace hsr::internal {

std::vector<Colour> face_colours(const Model& model, const Mesh& mesh, const View& view) {
  const Point3& e = view.viewpoint.at;
  const Point3 toward = unit(view.is_perspective() ? minus(e, view.target) : e);
  const Point3 right = unit(view.frame.right), up = unit(view.frame.up);
  const Point3 light = unit(
      {toward.x + 0.6 * up.x - 0.4 * right.x, toward.y + 0.6 * up.y - 0.4 * right.y, toward.z + 0.6 * up.z - 0.4 * right.z});
  std::vector<Colour> colours(mesh.faces.size(), Colour{200, 200, 200, 255});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FaceId f = mesh.face_of[TriangleId(t)];
    if (!model.face_colour.empty() && model.face_colour[f.value] != 0xffffffffU) {
      colours[f.value] = model.palette[model.face_colour[f.value]];
      continue;
    }
    if (t != mesh.first_triangle[f]) continue;
    const auto& c = mesh.triangles[TriangleId(t)];
    const Point3& o = mesh.points[c[0]];
    Point3 n = unit(cross(unit(minus(mesh.points[c[1]], o)), unit(minus(mesh.points[c[2]], o))));
    if (dot(n, toward) < 0) n = {-n.x, -n.y, -n.z};
    const double lit = std::max(0.0, dot(n, light));
    const auto grey = static_cast<std::uint8_t>(std::lround(110 + 135 * lit));
    colours[f.value] = {grey, grey, grey, 255};
  }
  return colours;
}

}  // namespace hsr::internal
