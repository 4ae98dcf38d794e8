#include "hsr/drawing/shading.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"

namespace hsr::internal {

std::vector<Colour> face_colours(const Model& model, const Mesh& mesh, const View& view, Shading shading) {
  const Point3& e = view.viewpoint.at;
  const Point3 toward = unit(view.is_perspective() ? minus(e, view.target) : e);
  const Point3 right = unit(view.frame.right), up = unit(view.frame.up);
  const Point3 light = unit(
      {toward.x + 0.6 * up.x - 0.4 * right.x, toward.y + 0.6 * up.y - 0.4 * right.y, toward.z + 0.6 * up.z - 0.4 * right.z});
  constexpr std::uint8_t brightest = 245, flat_grey = 200;
  std::vector<Colour> colours(mesh.faces.size());
  for (std::size_t f = 0; f < colours.size(); ++f) {
    const std::uint8_t grey = shading == Shading::slope ? brightest : flat_grey;
    const bool has_own = !model.face_colour.empty() && model.face_colour[f] != 0xffffffffU;
    colours[f] = has_own ? model.palette[model.face_colour[f]] : Colour{grey, grey, grey, 255};
    const std::uint32_t t = mesh.first_triangle[FaceId(f)];
    if (shading == Shading::none || t == mesh.first_triangle[FaceId(f + 1)]) continue;
    const auto& c = mesh.triangles[TriangleId(t)];
    const Point3& o = mesh.points[c[0]];
    Point3 n = unit(cross(unit(minus(mesh.points[c[1]], o)), unit(minus(mesh.points[c[2]], o))));
    if (dot(n, toward) < 0) n = {-n.x, -n.y, -n.z};
    const double lit = (110 + 135 * std::max(0.0, dot(n, light))) / brightest;
    for (std::size_t k = 0; k < 3; ++k) colours[f][k] = static_cast<std::uint8_t>(std::lround(lit * colours[f][k]));
  }
  return colours;
}

}  // namespace hsr::internal
