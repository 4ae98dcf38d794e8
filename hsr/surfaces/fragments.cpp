#include "hsr/surfaces/fragments.h"

#include <tbb/parallel_for.h>

#include "geometry/rational_vector.h"
#include "geometry/view_plane.h"

namespace hsr {

std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, TriangleId facet, const MapPoint& p) {
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
  if (p.is_vertex) {
    const auto& own = mesh.triangles[facet];
    if (p.vertex == own[0] || p.vertex == own[1] || p.vertex == own[2]) return rational(mesh.points[p.vertex]);
  }
  const Camera camera{view.viewpoint, view.target};
  if (!p.is_vertex) return exact_point(camera, view_plane(p.l), view_plane(p.m), face_plane(facet));
  return exact_point(camera, mesh.points[p.vertex], face_plane(facet));
}

std::vector<Rational> visible_areas(const Mesh& mesh, const View& view, const VisibleFragments& fragments) {
  std::vector<Rational> areas(fragments.fragments.size());
  const PaperImage image(view);
  tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t k) {
    const Fragment& f = fragments.fragments[k];
    Rational twice;
    for (std::uint32_t ring = f.first_ring; ring < f.end_ring; ++ring) {
      std::vector<std::array<Rational, 2>> at;
      for (const MapCorner& c : fragments.ring(ring)) {
        at.push_back(image(exact_point(mesh, view, f.facet, c.at)));
      }
      for (std::size_t i = 0; i < at.size(); ++i) {
        const auto &p = at[i], &q = at[(i + 1) % at.size()];
        twice = twice + (p[0] * q[1] - p[1] * q[0]);
      }
    }
    areas[k] = twice / Rational(2.0);
  });
  return areas;
}

}  // namespace hsr
