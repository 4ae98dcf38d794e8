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

/// The half-planes along an edge while places are passed where triangles begin to contain it, or end to: each is told from the others
/// once, however many places there are.
class PassingHalfPlanes {
 public:
  PassingHalfPlanes(const ProjectedMesh& projected, Predicates& exact, EdgeId id, const std::vector<Contact>& contacts)
      : planes_(projected, exact, projected.mesh().edges[id]) {
    for (const TriangleId t : projected.mesh().triangles_at(id)) begin_half(number(planes_.half_of(t)));
    for (const Contact& c : contacts) {
      halves_of_.emplace_back();
      contacts_.push_back(c.contact);
      is_there_.push_back(0);
      planes_.for_each_half(c.contact, [&](const HalfPlane& h) { halves_of_.back().push_back(number(h)); });
    }
  }

  void begin(std::size_t contact) {
    for (const std::uint32_t half : halves_of_[contact]) begin_half(half);
    is_there_[contact] = 1;
    ++count_;
  }
  void end(std::size_t contact) {
    for (const std::uint32_t half : halves_of_[contact]) {
      Present& p = present_[halves_[half].plane];
      p.halves.erase(std::lower_bound(p.halves.begin(), p.halves.end(), half));
      p.faces.erase(std::lower_bound(p.faces.begin(), p.faces.end(), halves_[half].half_plane.face));
    }
    is_there_[contact] = 0;
    --count_;
  }
  bool has_contacts() const { return count_ > 0; }
  /// By triangle.
  std::vector<EdgeContact> contacts() const {
    std::vector<EdgeContact> here;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      if (is_there_[k] != 0) here.push_back(contacts_[k]);
    return here;
  }
  /// Those that are there now, as if each triangle were added.
  void add_to(ExactHalfPlanes& here) const {
    for (const Present& p : present_)
      if (!p.halves.empty()) here.add(halves_[p.halves.front()].half_plane, p.faces);
  }

 private:
  /// A half-plane of one triangle, and which of those that differ it coincides with.
  struct Half {
    HalfPlane half_plane;
    std::size_t plane;
  };
  struct Present {
    std::vector<std::uint32_t> halves;  // ascending
    std::vector<FaceId> faces;          // theirs, ascending, each as often as it is there
  };

  std::uint32_t number(const HalfPlane& h) {
    const std::size_t plane = planes_.place(h);
    if (plane == present_.size()) present_.emplace_back();
    halves_.push_back({planes_.all()[plane], plane});
    halves_.back().half_plane.triangle = h.triangle;
    halves_.back().half_plane.apex = h.apex;
    halves_.back().half_plane.face = h.face;
    halves_.back().half_plane.coincident.clear();
    return static_cast<std::uint32_t>(halves_.size() - 1);
  }
  void begin_half(std::uint32_t half) {
    const HalfPlane& h = halves_[half].half_plane;
    Present& p = present_[halves_[half].plane];
    p.halves.insert(std::lower_bound(p.halves.begin(), p.halves.end(), half), half);
    p.faces.insert(std::upper_bound(p.faces.begin(), p.faces.end(), h.face), h.face);
  }

  ExactHalfPlanes planes_;  // all that differ
  std::vector<Half> halves_;
  std::vector<std::vector<std::uint32_t>> halves_of_;  // by contact
  std::vector<Present> present_;                       // by half-plane
  std::vector<EdgeContact> contacts_;                  // all
  std::vector<std::uint8_t> is_there_;                 // by contact
  std::size_t count_ = 0;                              // of those that are there
};

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
  struct Place {
    Breakpoint at;
    std::size_t contact;  // that begins or ends there; the number of contacts: none
    bool is_end;
  };
  const auto is_before = [&](const Place& x, const Place& y) { return occlusion.order(x.at, y.at) == Sign::negative; };
  std::vector<Place> places = {{occlusion.first(), contacts.size(), false}, {occlusion.last(), contacts.size(), false}};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    places.push_back({contacts[k].from, k, false});
    places.push_back({contacts[k].to, k, true});
  }
  std::stable_sort(places.begin(), places.end(), is_before);
  PassingHalfPlanes passing(classifier.projected(), occlusion.exact(), edge, contacts);
  const Edge& whole = classifier.projected().mesh().edges[edge];
  const auto class_here = [&] {
    if (!passing.has_contacts()) return classifier(occlusion.exact(), edge, {}, log);
    ExactHalfPlanes here(classifier.projected(), occlusion.exact(), whole);
    passing.add_to(here);
    if (!classifier.marks().is_empty()) classifier.add_marks(here, edge, passing.contacts());
    return with_wire(whole, classifier(here, whole.diagonal && !whole.of_face, log));
  };
  std::vector<EdgePart> parts;
  for (std::size_t k = 0, first = 0; k + 1 < places.size(); ++k) {
    if (!is_before(places[k], places[k + 1])) continue;
    for (const bool is_end : {false, true})
      for (std::size_t i = first; i <= k; ++i) {
        if (places[i].is_end != is_end || places[i].contact == contacts.size()) continue;
        is_end ? passing.end(places[i].contact) : passing.begin(places[i].contact);
      }
    first = k + 1;
    const PartClass found = class_here();
    if (!parts.empty() && parts.back().found == found)
      parts.back().to = places[k + 1].at.cut;
    else
      parts.push_back({found, places[k].at.cut, places[k + 1].at.cut});
  }
  // The first and the last place may have been named by a contact that begins or ends there.
  parts.front().from = occlusion.first().cut;
  parts.back().to = occlusion.last().cut;
  return parts;
}

}  // namespace hsr::internal
