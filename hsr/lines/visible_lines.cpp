#include "hsr/lines/visible_lines.h"

#include <algorithm>

#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

using namespace internal;

VisibleLines lines_of_classes(const Mesh& mesh, const VisibleLines& lines, const EdgeClasses& classes) {
  const auto is_only_diagonal = [&](EdgeId e) { return mesh.edges[e].diagonal && !mesh.edges[e].of_face; };
  VisibleLines some = lines;
  std::erase_if(some.lines, [&](const Line& line) {
    if (!classes[static_cast<std::size_t>(line.edge_class)]) return true;
    return line.edge_class == EdgeClass::smooth && !line.is_intersection() && !line.is_ghost && is_only_diagonal(line.edge);
  });
  // With a tolerance a line in which faces pierce each other may be of another class.
  if (std::none_of(some.lines.begin(), some.lines.end(), [](const Line& line) { return line.is_intersection(); }))
    some.intersections.clear();
  return some;
}

std::vector<FaceId> faces_at(const Mesh& mesh, const VisibleLines& lines, const Line& line) {
  std::vector<FaceId> faces;
  if (line.is_intersection()) {
    const Intersection& meet = lines.intersections[line.intersection];
    faces = {mesh.face_of[first_triangle(meet.s)], mesh.face_of[first_triangle(meet.t)]};
  } else if (line.is_ghost) {
    const Edge& edge = mesh.edges[line.edge];
    for (const TriangleId t : mesh.ghosts->triangles_at(mesh.ghosts->find_edge(edge.a, edge.b)))
      faces.push_back(mesh.ghosts->face_of[t]);
  } else {
    for (const TriangleId t : mesh.triangles_at(line.edge)) faces.push_back(mesh.face_of[t]);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::uint32_t object_of(const SceneObjects& objects, const Line& line, std::span<const FaceId> faces) {
  const bool is_of_edge = !line.is_intersection() && !line.is_ghost;
  if (is_of_edge && (line.edge_class == EdgeClass::wire || faces.empty())) return objects.object_of_wire(line.edge);
  return objects.object_of(faces);
}

SupportingLine supporting_line_of(const Mesh& mesh, const VisibleLines& lines, const Line& line) {
  if (line.is_intersection()) return {{}, {}, lines.intersections[line.intersection]};
  const Edge& edge = mesh.edges[line.edge];
  return {edge.a, edge.b, {}};
}

std::array<Plane, 2> planes_of(const Mesh& mesh, const View& view, const SupportingLine& support) {
  return {plane_of(mesh, view, {Cut::Kind::face, 0, support.meet.s.value, 0}),
          plane_of(mesh, view, {Cut::Kind::face, 0, support.meet.t.value, 0})};
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
