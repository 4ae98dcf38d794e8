#include "hsr/lines/near_parts.h"

#include "geometry/vector3.h"
#include "hsr/lines/near_half_planes.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

/// The class at a parameter of the line, by the faces that touch it there; nothing: none does.
std::optional<PartClass> NearParts::class_at(const Point3& a, const Point3& b, double at, std::span<const TriangleId> touching,
                                             bool only_diagonal, std::vector<CoincidentFaces>* log) const {
  const ProjectedMesh& projected = classifier_.projected();
  NearHalfPlanes half_planes(projected.mesh(), view_, a, b, sum(a, at, minus(b, a)), stretches_.tolerance(), projected.ties());
  for (const TriangleId t : touching) half_planes.add(t);
  if (!classifier_.marks().is_empty())
    for (const TriangleId t : touching) half_planes.add_marks(t, classifier_.marks());
  if (half_planes.all().empty()) return std::nullopt;
  return classifier_(half_planes, only_diagonal, log);
}

std::vector<EdgePart> NearParts::of_edge(TriangleOcclusion& occlusion, EdgeId id, std::vector<CoincidentFaces>* log) const {
  if (!occlusion.start(id)) return {whole_edge(classifier_, occlusion, id, nullptr)};
  const Mesh& mesh = classifier_.projected().mesh();
  const Edge& edge = mesh.edges[id];
  std::vector<EdgePart> parts;
  for (const NearStretch& s : stretches_.of_edge(occlusion, id)) {
    const auto around = class_at(mesh.points[edge.a], mesh.points[edge.b], (s.from.t + s.to.t) / 2, s.touching,
                                 edge.diagonal && !edge.of_face, log);
    const PartClass found = around ? with_wire(edge, *around) : classifier_(occlusion.exact(), id);
    if (!parts.empty() && parts.back().found == found)
      parts.back().to = s.to.cut;
    else
      parts.push_back({found, s.from.cut, s.to.cut});
  }
  return parts;
}

PartClass NearParts::of_intersection(const Intersection& meet, const Point3& a, const Point3& b, double at,
                                     std::span<const TriangleId> touching) const {
  const ProjectedMesh& projected = classifier_.projected();
  const Mesh& mesh = projected.mesh();
  const Point3 middle = sum(a, at, minus(b, a));
  const FaceId faces[2] = {mesh.face_of[first_triangle(meet.s)], mesh.face_of[first_triangle(meet.t)]};
  NearHalfPlanes half_planes(mesh, view_, a, b, middle, stretches_.tolerance(), projected.ties());
  NearHalfPlanes of_both(mesh, view_, a, b, middle, stretches_.tolerance(), projected.ties());
  for (const TriangleId t : touching) {
    half_planes.add(t);
    if (mesh.face_of[t] == faces[0] || mesh.face_of[t] == faces[1]) of_both.add(t);
  }
  if (half_planes.all().empty()) return {EdgeClass::intersection, {}, false, EdgeClass::intersection};
  std::vector<CoincidentFaces> log;
  const PartClass found = classifier_(half_planes, false, &log);
  // An edge that ends here may be an ulp behind: what is seen has its class. What is hidden is known to the edge.
  const bool is_in_doubt = found.alike != 0 && found.in_doubt != found.seen;
  const EdgeClass seen = is_in_doubt ? EdgeClass::smooth : found.seen.value_or(EdgeClass::smooth);
  // Both go on through the line by more than the tolerance, and in two planes: they pierce each other, noise or not.
  if (of_both.all().size() == 4) {
    const bool is_stronger = seen == EdgeClass::outline || seen == EdgeClass::boundary || seen == EdgeClass::sharp;
    return {is_stronger ? seen : EdgeClass::intersection, {}, false, EdgeClass::intersection};
  }
  // Where bodies touch nothing passes through anything else.
  const bool may_touch = found.hidden || found.alike != 0;
  return {seen, {}, false, may_touch ? EdgeClass::smooth : seen};
}

std::vector<EdgePart> NearParts::of_intersection(TriangleOcclusion& occlusion, const Intersection& meet) const {
  const Mesh& mesh = classifier_.projected().mesh();
  const auto point = [&](const Cut& cut) {
    const auto p = exact_point(mesh, view_, SupportingLine{{}, {}, meet}, cut);
    return Point3{p[0].to_double(), p[1].to_double(), p[2].to_double()};
  };
  const Point3 a = point(meet.from), b = point(meet.to);
  if (!occlusion.start(meet)) return {{of_intersection(meet, a, b, 0.5, {}), meet.from, meet.to}};
  std::vector<EdgePart> parts;
  for (const NearStretch& s : stretches_.of_line(occlusion, a, b)) {
    const PartClass found = of_intersection(meet, a, b, (s.from.t + s.to.t) / 2, s.touching);
    if (!parts.empty() && parts.back().found == found)
      parts.back().to = s.to.cut;
    else
      parts.push_back({found, s.from.cut, s.to.cut});
  }
  return parts;
}

}  // namespace hsr::internal
