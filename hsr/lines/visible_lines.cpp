#include "hsr/lines/visible_lines.h"

#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/scene/cut_plane.h"

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

VisibleLines lines_of_classes(const VisibleLines& lines, const std::array<bool, 6>& classes) {
  VisibleLines some = lines;
  std::erase_if(some.lines, [&](const Line& line) { return !classes[static_cast<std::size_t>(line.edge_class)]; });
  if (!classes[static_cast<std::size_t>(EdgeClass::intersection)]) some.intersections.clear();
  return some;
}

Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut) { return cut_plane(Given{mesh, view}, cut); }

SupportingLine supporting_line_of(const Mesh& mesh, const VisibleLines& lines, const Line& line) {
  if (line.is_intersection()) return {{}, {}, lines.intersections[line.intersection]};
  const Edge& edge = mesh.edges[line.edge];
  return {edge.a, edge.b, {}};
}

std::array<Plane, 2> planes_of(const Mesh& mesh, const View& view, const SupportingLine& support) {
  const Given given{mesh, view};
  return {given.face_plane(support.meet.s), given.face_plane(support.meet.t)};
}

std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return rational(mesh.points[support.a]);
  if (cut.kind == Cut::Kind::end) return rational(mesh.points[support.b]);
  const Plane plane = plane_of(mesh, view, cut);
  if (support.is_edge()) return ConstructedPoint::on_edge(mesh.points[support.a], mesh.points[support.b], plane).exact();
  const auto [s, t] = planes_of(mesh, view, support);
  return ConstructedPoint::meet(s, t, plane).exact();
}

std::array<Rational, 3> exact_point(const SceneView& scene, const VisibleLines& lines, const Line& line, std::uint32_t k) {
  const auto cuts = lines.cuts_of(line);
  require(k < cuts.size(), "exact_point: the line has fewer cuts");
  return exact_point(scene.mesh(), scene.view(), supporting_line_of(scene.mesh(), lines, line), cuts[k]);
}

Rational exact_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return 0.0;
  if (cut.kind == Cut::Kind::end) return 1.0;
  if (support.is_edge()) return parameter_of_cut(plane_of(mesh, view, cut), mesh.points[support.a], mesh.points[support.b]);
  if (cut == support.meet.from) return 0.0;
  if (cut == support.meet.to) return 1.0;
  const auto a = exact_point(mesh, view, support, support.meet.from), b = exact_point(mesh, view, support, support.meet.to),
             p = exact_point(mesh, view, support, cut);
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k] != b[k]) return (p[k] - a[k]) / (b[k] - a[k]);
  throw InvariantError("exact_parameter: an empty intersection");
}

}  // namespace hsr
