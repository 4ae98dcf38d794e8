#include "hsr/surfaces/fragments.h"

#include "geometry/rational_vector.h"
#include "geometry/view_plane.h"

namespace hsr {

std::array<Rational, 3> point_of(const Mesh& mesh, const View& view, TriangleId facet, const MapPoint& p) {
  const auto face_plane = [&](TriangleId t) {
    const auto& c = mesh.triangles[t];
    return Plane::of_face(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
  };
  const auto view_plane = [&](const MapLine& line) {
    if (line.kind == MapLine::Kind::edge)
      return ViewPlane::of(Plane::of_sight(view.viewpoint, mesh.points[VertexId(line.u)], mesh.points[VertexId(line.v)]));
    if (line.kind == MapLine::Kind::meet)
      return ViewPlane::of_meet(face_plane(TriangleId(line.u)), face_plane(TriangleId(line.v)));
    return ViewPlane::of(Plane::near_line(view.viewpoint.at, view.target, view.near, face_plane(TriangleId(line.u))));
  };
  const Camera camera{view.viewpoint, view.target};
  if (!p.is_vertex) return exact_point(camera, view_plane(p.l), view_plane(p.m), face_plane(facet));
  return exact_point(camera, mesh.points[p.vertex], face_plane(facet));
}

}  // namespace hsr
