#include "hsr/lines/near_parts.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"
#include "hsr/lines/near_half_planes.h"
#include "hsr/scene/half_space.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

namespace {

double length_of(const Point3& a) {
  const double most = norm_max(a);
  return most > 0 ? most * std::sqrt(dot(over(a, most), over(a, most))) : 0;
}

}  // namespace

std::vector<NearParts::Contact> NearParts::contacts(const Point3& a, const Point3& b) const {
  std::vector<Contact> all;
  triangles_.visit_near(a, b, tolerance_, [&](TriangleId t) {
    if (const auto contact = near_contact(mesh_, t, a, b, tolerance_)) all.push_back({*contact, t});
  });
  std::sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) { return x.triangle < y.triangle; });
  return all;
}

/// The class at a parameter of the line, by the faces that are near there; nothing: none is.
std::optional<PartClass> NearParts::class_at(const Point3& a, const Point3& b, double at, const std::vector<Contact>& near,
                                             bool only_diagonal, std::vector<CoincidentFaces>* log) const {
  NearHalfPlanes half_planes(mesh_, view_, a, b, sum(a, at, minus(b, a)), tolerance_, projected_.ties());
  for (const Contact& c : near)
    if (c.from <= at && at <= c.to) half_planes.add(c.triangle);
  if (half_planes.all().empty()) return std::nullopt;
  return classifier_(half_planes, only_diagonal, log);
}

/// Where the border of a triangle crosses the edge, by name; nothing where that is not near the parameter `at`.
void NearParts::add_place(TriangleOcclusion& occlusion, EdgeId id, TriangleId triangle, std::size_t side, double at,
                          double length, std::vector<Breakpoint>& places) const {
  if (side == 3) return;
  const Edge& edge = mesh_.edges[id];
  const HalfSpace h = half_spaces(projected_, triangle, occlusion.exact())[side];
  Sign ends[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const VertexId v = k == 0 ? edge.a : edge.b;
    ends[k] = v.value == h.cut.u || v.value == h.cut.v ? Sign::zero : projected_.side(h.plane, v, occlusion.exact());
  }
  if (ends[0] * ends[1] != Sign::negative) return;
  const Breakpoint place = occlusion.place(h.cut);
  if (std::fabs(place.t - at) * length > 8 * tolerance_) return;
  if (occlusion.order(occlusion.first(), place) == Sign::negative && occlusion.order(place, occlusion.last()) == Sign::negative)
    places.push_back(place);
}

std::vector<EdgePart> NearParts::of_edge(TriangleOcclusion& occlusion, EdgeId id, std::vector<CoincidentFaces>* log) const {
  if (!occlusion.start(id)) return {whole_edge(classifier_, occlusion, id, nullptr)};
  const Edge& edge = mesh_.edges[id];
  const Point3 &a = mesh_.points[edge.a], &b = mesh_.points[edge.b];
  const double length = length_of(minus(b, a));
  const std::vector<Contact> near = contacts(a, b);
  std::vector<Breakpoint> places;
  for (const Contact& c : near) {
    add_place(occlusion, id, c.triangle, c.side_from, c.from, length, places);
    add_place(occlusion, id, c.triangle, c.side_to, c.to, length, places);
  }
  std::stable_sort(places.begin(), places.end(),
                   [&](const Breakpoint& x, const Breakpoint& y) { return occlusion.order(x, y) == Sign::negative; });
  std::vector<EdgePart> parts;
  Breakpoint from = occlusion.first();
  for (std::size_t k = 0; k <= places.size(); ++k) {
    const Breakpoint& to = k < places.size() ? places[k] : occlusion.last();
    // Of places nearer to one another than the tolerance, and to an end, one is enough.
    const bool is_short = (to.t - from.t) * length <= 2 * tolerance_;
    if (is_short && (k < places.size() || !parts.empty())) continue;
    const auto around = class_at(a, b, (from.t + to.t) / 2, near, edge.diagonal && !edge.of_face, log);
    const PartClass found = around ? with_wire(edge, *around) : classifier_(occlusion.exact(), id);
    if (!parts.empty() && parts.back().found == found)
      parts.back().to = to.cut;
    else
      parts.push_back({found, from.cut, to.cut});
    from = to;
  }
  parts.back().to = occlusion.last().cut;
  return parts;
}

PartClass NearParts::of_intersection(const Point3& from, const Point3& to) const {
  std::vector<CoincidentFaces> log;
  PartClass found = class_at(from, to, 0.5, contacts(from, to), false, &log).value_or(PartClass{EdgeClass::intersection});
  // Where bodies touch nothing passes through anything else: what ends here has its edges, and these know what is seen and what is
  // hidden of them.
  const bool may_touch = found.hidden || found.alike != 0;
  if (may_touch && found.seen != EdgeClass::intersection) found.seen = EdgeClass::smooth;
  return found;
}

}  // namespace hsr::internal
