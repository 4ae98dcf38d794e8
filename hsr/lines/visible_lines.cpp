#include "hsr/lines/visible_lines.h"

#include "geometry/constructed_point.h"
#include "hsr/lines/cut_plane.h"

namespace hsr {

namespace {

/// The points as given, unscaled.
struct Given {
  const Mesh& mesh;
  const View& view;

  const Point3& point(VertexId v) const { return mesh.points[v]; }
  const Viewpoint& eye() const { return view.viewpoint; }
  Plane sight_plane(VertexId c, VertexId d) const { return Plane::of_sight(view.viewpoint, point(c), point(d)); }
  Plane face_plane(TriangleId t) const {
    const auto& corners = mesh.triangles[t];
    return Plane::of_face(point(corners[0]), point(corners[1]), point(corners[2]));
  }
  Plane near_plane() const { return view.near_plane(); }
  Plane near_line(const Plane& line) const { return Plane::near_line(view.viewpoint.at, view.target, view.near, line); }
};

}  // namespace

Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut) { return cut_plane(Given{mesh, view}, cut); }

Rational parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return 0.0;
  if (cut.kind == Cut::Kind::end) return 1.0;
  return parameter_of_cut(plane_of(mesh, view, cut), mesh.points[edge.a], mesh.points[edge.b]);
}

}  // namespace hsr
