#include "hsr/lines/clear_shadows.h"

#include <algorithm>

#include "geometry/vector3.h"
#include "hsr/lines/near_half_planes.h"

namespace hsr::internal {

/// A face in which the edge lies, but for noise; not one seen edge-on that starts toward the eye, which hides it with or without.
bool ClearShadows::hides_by_noise(EdgeId id, const NearStretch& stretch, TriangleId touching) const {
  const Mesh& mesh = projected_.mesh();
  const Point3 &a = mesh.points[mesh.edges[id].a], &b = mesh.points[mesh.edges[id].b];
  const Point3 middle = sum(a, (stretch.from.t + stretch.to.t) / 2, minus(b, a));
  NearHalfPlanes half_planes(mesh, view_, a, b, middle, stretches_.tolerance(), projected_.ties());
  half_planes.add(touching);
  const auto& all = half_planes.all();
  return std::none_of(all.begin(), all.end(), [](const HalfPlane& h) { return h.is_front; });
}

/// Appends the clear shadows on what of a stretch is in the part.
void ClearShadows::cast_on(const RequestedPart& part, const NearStretch& stretch) {
  const Edge& edge = projected_.mesh().edges[part.edge];
  occlusion_.start(part.edge, part.from, part.to);
  const Breakpoint from = occlusion_.first(), to = occlusion_.last();
  const bool begins_within = occlusion_.order(from, stretch.from) == Sign::negative;
  const bool ends_within = occlusion_.order(stretch.to, to) == Sign::negative;
  const Breakpoint &first = begins_within ? stretch.from : from, &last = ends_within ? stretch.to : to;
  if (occlusion_.order(first, last) != Sign::negative) return;
  std::vector<TriangleId> noise;
  for (const TriangleId t : stretch.touching)
    if (hides_by_noise(part.edge, stretch, t)) noise.push_back(t);
  occlusion_.start(part.edge, first.cut, last.cut);
  all_.tree.visit(projected_.box(edge.a, edge.b), [&](std::uint32_t i) {
    const TriangleId t = all_.triangles[i];
    if (!std::binary_search(noise.begin(), noise.end(), t)) occlusion_.cast(t, shadows_);
    return true;
  });
}

void ClearShadows::turn_to(const RequestedPart& part) {
  shadows_.clear();
  occlusion_.start(part.edge);
  for (const NearStretch& stretch : stretches_.of_edge(occlusion_, part.edge)) cast_on(part, stretch);
  occlusion_.start(part.edge, part.from, part.to);
  unite(occlusion_, shadows_);
}

Breakpoint ClearShadows::place(const Cut& cut) {
  for (const Breakpoint& end : {occlusion_.first(), occlusion_.last()})
    if (cut == end.cut) return end;
  return occlusion_.place(cut);
}

ClearShadows::Divided ClearShadows::divided(const Cut& from, const Cut& to) {
  const Breakpoint begin = place(from), end = place(to);
  const auto is_before = [&](const Breakpoint& x, const Breakpoint& y) { return occlusion_.order(x, y) == Sign::negative; };
  Divided all{false, {from}};
  for (const HiddenInterval& s : shadows_) {
    if (!is_before(begin, s.to)) continue;
    if (!is_before(s.from, end)) break;
    if (is_before(begin, s.from))
      all.cuts.push_back(s.from.cut);
    else
      all.starts_clear = true;
    if (!is_before(s.to, end)) break;
    all.cuts.push_back(s.to.cut);
  }
  all.cuts.push_back(to);
  return all;
}

}  // namespace hsr::internal
