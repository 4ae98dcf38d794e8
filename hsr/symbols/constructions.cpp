#include "hsr/symbols/constructions.h"

#include "geometry/rational_vector.h"
#include "geometry/view_plane.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr {

using namespace internal;

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
  Plane face_plane(FacetId facet) const { return face_plane(first_triangle(facet)); }
  Plane cutting_plane(std::uint8_t k) const { return view.cutting_plane(k); }
  Plane fold_plane(std::uint8_t u, std::uint8_t v) const { return view.fold_plane(u, v); }
};

}  // namespace

Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut) { return cut_plane(Given{mesh, view}, cut); }

std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, FacetId facet, const MapPoint& p) {
  if (p.is_vertex) {
    const auto& own = mesh.triangles[first_triangle(facet)];
    if (p.vertex == own[0] || p.vertex == own[1] || p.vertex == own[2]) return rational(mesh.points[p.vertex]);
  }
  return exact_point(mesh, view, Given{mesh, view}.face_plane(facet), p);
}

std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, const Plane& plane, const MapPoint& p) {
  const Given given{mesh, view};
  const auto view_plane = [&](const MapLine& line) {
    if (line.kind == MapLine::Kind::edge) return ViewPlane::of(given.sight_plane(VertexId(line.u), VertexId(line.v)));
    if (line.kind == MapLine::Kind::meet)
      return ViewPlane::of_meet(given.face_plane(TriangleId(line.u)), given.face_plane(TriangleId(line.v)));
    const auto v = static_cast<std::uint8_t>(line.v);
    if (line.kind == MapLine::Kind::fold) return ViewPlane::of(given.fold_plane(static_cast<std::uint8_t>(line.u), v));
    return ViewPlane::of(given.cutting_plane(v).line_with(given.face_plane(TriangleId(line.u))));
  };
  const Camera camera{view.viewpoint, view.target};
  if (p.is_vertex) return exact_point(camera, mesh.points[p.vertex], plane);
  return exact_point(camera, view_plane(p.l), view_plane(p.m), plane);
}

}  // namespace hsr
