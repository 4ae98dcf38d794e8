#include "hsr/lines/edge_parts.h"

#include <algorithm>

#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

struct Contact {
  EdgeContact contact;
  Breakpoint from, to;
};

/// Which triangles contain a part of the edge that the shadows were turned to. Where it runs along an edge of the mesh, all
/// triangles at that count: far sides of bodies, which are no occluders, too.
std::vector<Contact> contacts_of(const ProjectedMesh& projected, TriangleOcclusion& occlusion, EdgeId id,
                                 const Occluders& occluders) {
  const Mesh& mesh = projected.mesh();
  const Edge& edge = mesh.edges[id];
  const auto own = mesh.triangles_at(id);
  std::vector<Contact> all;
  const auto add = [&](const Contact& found) {
    if (std::find(own.begin(), own.end(), found.contact.triangle) == own.end()) all.push_back(found);
  };
  occluders.tree.visit_touching(projected.box(edge.a, edge.b), [&](std::uint32_t i) {
    const TriangleId t = occluders.triangles[i];
    if (std::find(own.begin(), own.end(), t) != own.end()) return true;
    const auto& c = mesh.triangles[t];
    const Plane plane = projected.face_plane(t);
    for (const VertexId v : {edge.a, edge.b})
      if (std::find(c.begin(), c.end(), v) == c.end() && projected.side(plane, v, occlusion.exact()) != Sign::zero) return true;
    Contact found{{t, 3}, {}, {}};
    if (!occlusion.within(half_spaces(projected, t, occlusion.exact()), found.from, found.to, found.contact.along)) return true;
    add(found);
    if (found.contact.along == 3) return true;
    const VertexId u = c[found.contact.along], v = c[(found.contact.along + 1) % 3];
    const EdgeId along = mesh.find_edge(u, v);
    if (!along.is_valid()) return true;
    for (const TriangleId other : mesh.triangles_at(along)) {
      if (other == t) continue;
      const auto& d = mesh.triangles[other];
      std::size_t k = 0;
      while (!((d[k] == u && d[(k + 1) % 3] == v) || (d[k] == v && d[(k + 1) % 3] == u))) ++k;
      found.contact = {other, k};
      add(found);
    }
    return true;
  });
  std::sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) { return x.contact.triangle < y.contact.triangle; });
  // One triangle contains one part of the edge, however it was found.
  const auto same = [](const Contact& x, const Contact& y) { return x.contact.triangle == y.contact.triangle; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace

EdgePart whole_edge(const EdgeClassifier& classifier, TriangleOcclusion& occlusion, EdgeId edge,
                    std::vector<CoincidentFaces>* log) {
  const std::size_t logged = log == nullptr ? 0 : log->size();
  EdgePart part{classifier(occlusion.exact(), edge, {}, log), {Cut::Kind::start, 0, 0, 0}, {Cut::Kind::end, 0, 0, 0}};
  const bool is_logged = log != nullptr && log->size() > logged;
  if (!part.found.depends_on_more() && !is_logged) return part;
  if (!occlusion.start(edge)) {
    if (is_logged) log->pop_back();
    part.found = {part.found.seen};
    return part;
  }
  part.from = occlusion.first().cut;
  part.to = occlusion.last().cut;
  return part;
}

std::vector<EdgePart> edge_parts(const EdgeClassifier& classifier, TriangleOcclusion& occlusion, EdgeId edge,
                                 const Occluders& occluders, std::vector<CoincidentFaces>* log) {
  if (!occlusion.start(edge)) return {whole_edge(classifier, occlusion, edge, nullptr)};
  const std::vector<Contact> contacts = contacts_of(classifier.projected(), occlusion, edge, occluders);
  if (contacts.empty()) return {whole_edge(classifier, occlusion, edge, log)};
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
    const PartClass found = classifier(occlusion.exact(), edge, here, log);
    if (!parts.empty() && parts.back().found == found)
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
