#include "hsr/lines/edge_parts.h"

#include <algorithm>

#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

struct Contact {
  EdgeContact contact;
  Breakpoint from, to;
};

/// Which triangles contain a part of the edge that the shadows were turned to.
std::vector<Contact> contacts_of(const ProjectedMesh& projected, TriangleOcclusion& occlusion, EdgeId id,
                                 const Occluders& occluders) {
  const Mesh& mesh = projected.mesh();
  const Edge& edge = mesh.edges[id];
  const auto own = mesh.triangles_at(id);
  std::vector<Contact> all;
  occluders.tree.visit_touching(projected.box(edge.a, edge.b), [&](std::uint32_t i) {
    const TriangleId t = occluders.triangles[i];
    if (std::find(own.begin(), own.end(), t) != own.end()) return true;
    const auto& c = mesh.triangles[t];
    const Plane plane = projected.face_plane(t);
    for (const VertexId v : {edge.a, edge.b})
      if (std::find(c.begin(), c.end(), v) == c.end() && projected.side(plane, v, occlusion.exact()) != Sign::zero) return true;
    Contact found{{t, 3}, {}, {}};
    if (!occlusion.within(half_spaces(projected, t, occlusion.exact()), found.from, found.to, found.contact.along)) return true;
    if (found.contact.along < 3 && !is_inner_diagonal(mesh, t, found.contact.along)) return true;
    all.push_back(found);
    return true;
  });
  return all;
}

}  // namespace

std::vector<EdgePart> edge_parts(const ProjectedMesh& projected, TriangleOcclusion& occlusion, EdgeId edge,
                                 const Crease& crease, const Occluders& occluders) {
  const auto whole = [&] {
    return std::vector<EdgePart>{
        {edge_class(projected, occlusion.exact(), edge, crease), {Cut::Kind::start, 0, 0, 0}, {Cut::Kind::end, 0, 0, 0}}};
  };
  if (!occlusion.start(edge)) return whole();
  std::vector<Contact> contacts = contacts_of(projected, occlusion, edge, occluders);
  if (contacts.empty()) return whole();
  std::sort(contacts.begin(), contacts.end(),
            [](const Contact& x, const Contact& y) { return x.contact.triangle < y.contact.triangle; });
  const auto is_before = [&](const Breakpoint& x, const Breakpoint& y) { return occlusion.order(x, y) == Sign::negative; };
  std::vector<Breakpoint> places = {occlusion.first(), occlusion.last()};
  for (const Contact& c : contacts) {
    places.push_back(c.from);
    places.push_back(c.to);
  }
  std::stable_sort(places.begin(), places.end(), is_before);
  std::vector<EdgePart> parts;
  std::vector<EdgeContact> here;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (!is_before(places[k], places[k + 1])) continue;
    here.clear();
    for (const Contact& c : contacts)
      if (!is_before(places[k], c.from) && !is_before(c.to, places[k + 1])) here.push_back(c.contact);
    const auto found = edge_class(projected, occlusion.exact(), edge, crease, here);
    if (!parts.empty() && parts.back().edge_class == found)
      parts.back().to = places[k + 1].cut;
    else
      parts.push_back({found, places[k].cut, places[k + 1].cut});
  }
  // The first and the last place may have been named by a contact that begins or ends there.
  parts.front().from = occlusion.first().cut;
  parts.back().to = occlusion.last().cut;
  return parts;
}

}  // namespace hsr::internal
