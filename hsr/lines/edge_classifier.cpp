#include "hsr/lines/edge_classifier.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"

namespace hsr::internal {

/// What is looked at of the half-planes around a part, for the class of what is seen, or of what is behind.
struct EdgeClassifier::Around {
  const HalfPlane *left = nullptr, *right = nullptr;  // the nearest, or the farthest, on each side of the view plane
  const HalfPlane* edge_on = nullptr;                 // the one toward the eye, or the one away from it
};

namespace {

/// Whether a surface goes on through the edge as this half-plane and its opposite, with others on both sides of it. Bodies that
/// touch pierce nothing.
bool is_pierced(const HalfPlanes& half_planes, const HalfPlane& h) {
  bool goes_on = false, positive = false, negative = false;
  for (const HalfPlane& other : half_planes.all()) {
    if (&other == &h || other.is_contact) continue;
    const Sign s = half_planes.side(h, other);
    goes_on = goes_on || s == Sign::zero;  // each half-plane is there once
    positive = positive || s == Sign::positive;
    negative = negative || s == Sign::negative;
  }
  return goes_on && positive && negative;
}

bool is_flat(const std::optional<EdgeClass>& c) {
  return c == EdgeClass::material || c == EdgeClass::joint || c == EdgeClass::smooth;
}

}  // namespace

PartClass with_wire(const Edge& edge, PartClass found) {
  const bool is_plain = !found.seen || found.seen == EdgeClass::smooth || found.seen == EdgeClass::joint;
  if (edge.wire && is_plain) found.seen = EdgeClass::wire;
  const bool is_plain_where_hidden = found.hidden == EdgeClass::smooth || found.hidden == EdgeClass::joint;
  if (edge.wire && is_plain_where_hidden) found.hidden = EdgeClass::wire;
  if (found.hidden == found.seen) found.hidden.reset();
  return found;
}

/// What marks and surfaces say of the edge between two half-planes, each given by the faces in it: the strongest mark of an object that
/// both have a face of; without one, inner if both have a face of one surface.
std::optional<EdgeMark> EdgeClassifier::mark_between(std::span<const FaceId> left, std::span<const FaceId> right,
                                                     std::span<const MarkOfObject> marks) const {
  const auto has_face_of = [&](std::span<const FaceId> faces, std::uint32_t object) {
    return labels_.object.empty() ||
           std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return labels_.object[f.value] == object; });
  };
  std::optional<EdgeMark> strongest;
  for (const MarkOfObject& m : marks)
    if ((!strongest || m.mark > *strongest) && has_face_of(left, m.object) && has_face_of(right, m.object)) strongest = m.mark;
  if (strongest || labels_.surface.empty()) return strongest;
  for (const FaceId f : left)
    for (const FaceId g : right) {
      const std::uint32_t surface = labels_.surface[f.value];
      if (surface != FaceLabels::none && surface == labels_.surface[g.value]) return EdgeMark::inner;
    }
  return std::nullopt;
}

/// @pre both are there
std::optional<EdgeMark> EdgeClassifier::mark_of(const HalfPlanes& half_planes, const Around& around) const {
  if (half_planes.marks().empty() && labels_.surface.empty()) return std::nullopt;
  const auto faces_in = [](const HalfPlane& h) {
    return h.coincident.empty() ? std::span<const FaceId>(&h.face, 1) : std::span<const FaceId>(h.coincident);
  };
  return mark_between(faces_in(*around.left), faces_in(*around.right), half_planes.marks());
}

/// Intersection or sharp; nothing: the surface goes on from left to right. @pre both are there
std::optional<EdgeClass> EdgeClassifier::more_than_flat(const HalfPlanes& half_planes, const Around& around) const {
  const bool is_bent = half_planes.side(*around.left, *around.right) != Sign::zero;
  const std::optional<EdgeMark> mark = mark_of(half_planes, around);
  if (!is_bent && around.edge_on == nullptr) return mark == EdgeMark::sharp ? std::optional(EdgeClass::sharp) : std::nullopt;
  for (const HalfPlane* h : {around.left, around.right, around.edge_on})
    if (h != nullptr && is_pierced(half_planes, *h)) return EdgeClass::intersection;
  if (around.edge_on != nullptr) return EdgeClass::sharp;
  if (mark) return *mark == EdgeMark::sharp ? std::optional(EdgeClass::sharp) : std::nullopt;
  const bool is_sharp = half_planes.deviation_from_flat(*around.left, *around.right) > crease_.degrees;
  return is_sharp ? std::optional(EdgeClass::sharp) : std::nullopt;
}

/// Where all half-planes are seen edge-on: whether two of them, and no others, are of one surface.
bool EdgeClassifier::is_inner_edge_on(const HalfPlanes& half_planes) const {
  const auto& all = half_planes.all();
  return all.size() == 2 && mark_of(half_planes, {&all[0], &all[1]}) == EdgeMark::inner;
}

/// The class where two faces go on into each other.
EdgeClass EdgeClassifier::flat(FaceId left, FaceId right) const {
  const auto differ = [&](const std::vector<std::uint32_t>& label) {
    return !label.empty() && label[left.value] != label[right.value];
  };
  if (differ(labels_.material)) return EdgeClass::material;
  return differ(labels_.object) ? EdgeClass::joint : EdgeClass::smooth;
}

/// @param contacts how the half-planes in which bodies touch count, or may touch: those in which more faces coincide than
///   `surface` count only where they are the nearest on their side, if they count only on top
PartClass EdgeClassifier::class_of(const HalfPlanes& half_planes, bool only_diagonal, Contacts contacts,
                                   std::size_t surface) const {
  const auto side_of = [](auto& pair, const HalfPlane& h) -> auto& { return pair[h.side == Sign::positive ? 0 : 1]; };
  const HalfPlane *nearest[2] = {nullptr, nullptr}, *farthest[2] = {nullptr, nullptr}, *front = nullptr, *back = nullptr;
  std::size_t count = 0;
  for (const HalfPlane& h : half_planes.all()) {
    if (contacts == Contacts::left_out && h.is_contact) continue;
    ++count;
    if (h.side == Sign::zero) continue;
    auto& first = side_of(nearest, h);
    if (first == nullptr || half_planes.is_nearer(h, *first)) first = &h;
  }
  if ((nearest[0] == nullptr) != (nearest[1] == nullptr) && (only_diagonal || count > 1)) return {EdgeClass::outline};
  if (only_diagonal || count == 0) return {};
  if (count == 1) return {EdgeClass::boundary};
  if (nearest[0] == nullptr) return is_inner_edge_on(half_planes) ? PartClass{} : PartClass{EdgeClass::smooth};
  for (const HalfPlane& h : half_planes.all()) {
    if (contacts == Contacts::left_out && h.is_contact) continue;
    const bool is_on_top = h.side != Sign::zero && &h == side_of(nearest, h);
    if (contacts == Contacts::only_on_top && h.faces() > surface && !is_on_top) continue;
    if (h.side == Sign::zero) {
      (h.is_front ? front : back) = &h;
      continue;
    }
    auto& last = side_of(farthest, h);
    if (last == nullptr || half_planes.is_nearer(*last, h)) last = &h;
  }
  const auto seen = more_than_flat(half_planes, {nearest[0], nearest[1], front});
  if (seen) return {seen};
  const auto behind = more_than_flat(half_planes, {farthest[0], farthest[1], back});
  const std::optional<EdgeMark> mark = mark_of(half_planes, {nearest[0], nearest[1]});
  if (mark == EdgeMark::inner) return {{}, behind};
  const bool may_go_on = !mark && crease_.goes_on_degrees < crease_.degrees &&
                         half_planes.deviation_from_flat(*nearest[0], *nearest[1]) > crease_.goes_on_degrees;
  return {flat(nearest[0]->face, nearest[1]->face), behind, may_go_on};
}

PartClass EdgeClassifier::operator()(HalfPlanes& half_planes, bool only_diagonal, std::vector<CoincidentFaces>* log) const {
  const Touching touching = mark_contacts(half_planes);
  std::size_t least = half_planes.all().empty() ? 1 : half_planes.all().front().faces();
  for (const HalfPlane& h : half_planes.all()) least = std::min(least, h.faces());
  PartClass found =
      class_of(half_planes, only_diagonal, touching == Touching::open ? Contacts::only_on_top : Contacts::count, least);
  if (touching == Touching::nothing) return found;
  if (log != nullptr) {
    log->push_back({touching, {}});
    for (const HalfPlane& h : half_planes.all()) {
      const bool tells = touching == Touching::bodies ? h.is_contact : touching == Touching::alike || !goes_on(half_planes, h);
      if (h.faces() > 1 && tells) log->back().sets.push_back(h.coincident);
    }
  }
  if (touching == Touching::alike && log != nullptr) {
    found.alike = static_cast<std::uint32_t>(log->size());
    found.in_doubt = class_of(half_planes, only_diagonal, Contacts::only_on_top, least / 2).seen;
  }
  if (touching != Touching::bodies) return found;
  const PartClass hidden = class_of(half_planes, only_diagonal, Contacts::left_out);
  found.behind = hidden.behind;
  if (log != nullptr && is_flat(found.seen)) {
    const auto behind = class_of(half_planes, only_diagonal, Contacts::only_on_top, least).behind;
    if (behind && behind != found.behind) found.behind_seen = behind;
  }
  // What is nothing where it is seen is nothing where it is hidden.
  if (found.seen && hidden.seen != found.seen) found.hidden = hidden.seen.value_or(EdgeClass::smooth);
  return found;
}

/// An edge of two faces on opposite sides whose angle is far enough from the crease: found without any exact sign. Nothing: to be
/// looked at closely. Each normal is good to nine digits, and the cosine is trusted to six.
std::optional<PartClass> EdgeClassifier::at_a_glance(EdgeId id) const {
  const Edge& edge = projected_.mesh().edges[id];
  const auto triangles = projected_.mesh().triangles_at(id);
  if (triangles.size() != 2 || !edge.of_face || edge.wire) return std::nullopt;
  Point3 n[2];
  Sign side[2];
  const Point3& a = projected_.point(edge.a);
  const Point3 along = minus(projected_.point(edge.b), a);
  for (std::size_t k = 0; k < 2; ++k) {
    const TriangleId t = triangles[k];
    side[k] = projected_.side_of_edge(t, edge);
    const Point3 out = minus(projected_.point(projected_.mesh().apex(t, edge)), a);
    n[k] = cross(along, out);
    // The normal errs by some roundings of these products.
    if (!(norm_max(n[k]) > norm_max(along) * norm_max(out) * 0x1p-20)) return std::nullopt;
  }
  if (side[0] * side[1] != Sign::negative) return std::nullopt;
  const Mesh& mesh = projected_.mesh();
  const FaceId faces[2] = {mesh.face_of[triangles[0]], mesh.face_of[triangles[1]]};
  if (const auto mark = mark_between({&faces[0], 1}, {&faces[1], 1}, marks_.of(edge.a, edge.b))) {
    if (*mark == EdgeMark::inner) return PartClass{};
    return PartClass{*mark == EdgeMark::sharp ? EdgeClass::sharp : flat(faces[0], faces[1])};
  }
  const double square = dot(n[0], n[0]) * dot(n[1], n[1]);
  if (!(square > 0x1p-900 && square < 0x1p900)) return std::nullopt;
  const double flatness = -dot(n[0], n[1]) / std::sqrt(square);  // the cosine of the deviation from flat
  if (flatness > crease_.cosine + 1e-6) return PartClass{flat(faces[0], faces[1]), {}, flatness < crease_.goes_on_cosine};
  if (flatness < crease_.cosine - 1e-6) return PartClass{EdgeClass::sharp};
  return std::nullopt;
}

void EdgeClassifier::add_marks(HalfPlanes& half_planes, EdgeId id, std::span<const EdgeContact> contacts) const {
  if (marks_.is_empty()) return;
  const Mesh& mesh = projected_.mesh();
  if (!mesh.triangles_at(id).empty()) half_planes.add_marks(marks_.of(mesh.edges[id].a, mesh.edges[id].b));
  for (const EdgeContact& c : contacts) {
    if (c.along == 3) continue;
    const auto& corners = mesh.triangles[c.triangle];
    half_planes.add_marks(marks_.of(corners[c.along], corners[(c.along + 1) % 3]));
  }
}

PartClass EdgeClassifier::operator()(Predicates& exact, EdgeId id, std::span<const EdgeContact> contacts,
                                     std::vector<CoincidentFaces>* log) const {
  if (exact.arithmetic() == Arithmetic::staged && contacts.empty())
    if (const auto found = at_a_glance(id)) return *found;
  const Edge& edge = projected_.mesh().edges[id];
  ExactHalfPlanes half_planes(projected_, exact, edge);
  for (const TriangleId t : projected_.mesh().triangles_at(id)) half_planes.add(t);
  for (const EdgeContact& c : contacts) half_planes.add(c);
  add_marks(half_planes, id, contacts);
  return with_wire(edge, (*this)(half_planes, edge.diagonal && !edge.of_face, log));
}

}  // namespace hsr::internal
