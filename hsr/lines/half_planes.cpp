#include "hsr/lines/half_planes.h"

#include <algorithm>
#include <utility>

#include "hsr/scene/facet.h"
#include "hsr/scene/half_space.h"

namespace hsr::internal {

void ExactHalfPlanes::for_each_half(const EdgeContact& contact, const std::function<void(const HalfPlane&)>& f) const {
  const auto& c = projected_.mesh().triangles[contact.triangle];
  const bool edge_on = projected_.facing(contact.triangle) == Sign::zero;
  const Point3 &a = projected_.point(edge_.a), &b = projected_.point(edge_.b);
  const Plane line = edge_on ? Plane::along_axis(a, b, dropped_axis(projected_, contact.triangle, exact_))
                             : projected_.sight_plane(edge_.a, edge_.b);
  bool has[2] = {false, false};
  for (std::size_t k = 0; k < 3; ++k) {
    if (contact.along < 3 && k != (contact.along + 2) % 3) continue;
    const Sign s = exact_.side(line, projected_.point(c[k]));
    if (s == Sign::zero || has[s == Sign::positive ? 0 : 1]) continue;
    has[s == Sign::positive ? 0 : 1] = true;
    f({contact.triangle, c[k], edge_on ? Sign::zero : s, false, projected_.mesh().face_of[contact.triangle]});
  }
}

std::size_t ExactHalfPlanes::place(const HalfPlane& other) {
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (coincide(all_[k], other)) return k;
  all_.push_back(other);
  if (other.side == Sign::zero) all_.back().is_front = starts_toward_eye(other);
  return all_.size() - 1;
}

void ExactHalfPlanes::add(const HalfPlane& added) {
  const std::size_t before = all_.size(), at = place(added);
  if (at < before) share(all_[at], added.face);
}

void ExactHalfPlanes::add(HalfPlane half_plane, std::span<const FaceId> faces) {
  half_plane.face = ties().is_above(faces.back(), faces.front()) ? faces.back() : faces.front();
  if (faces.size() > 1) half_plane.coincident.assign(faces.begin(), faces.end());
  all_.push_back(std::move(half_plane));
}

bool ExactHalfPlanes::coincide(const HalfPlane& x, const HalfPlane& y) const {
  if (x.side != y.side || side(x, y) != Sign::zero) return false;
  // In one plane with the edge: on the same side of it where the plane is seen as two coordinates.
  for (int axis = 0; axis < 3; ++axis) {
    const Plane line = Plane::along_axis(projected_.point(edge_.a), projected_.point(edge_.b), axis);
    const Sign s = exact_.side(line, projected_.point(x.apex));
    if (s != Sign::zero) return s == exact_.side(line, projected_.point(y.apex));
  }
  return true;
}

/// In the view plane, with a coordinate dropped: whether the eye and the apex are on one side of the line of the edge.
bool ExactHalfPlanes::starts_toward_eye(const HalfPlane& edge_on) const {
  const int axis = dropped_axis(projected_, edge_on.triangle, exact_);
  const Point3 &a = projected_.point(edge_.a), &b = projected_.point(edge_.b);
  const Sign eye = exact_.side(Plane::of_sight_along_axis(projected_.eye(), a, axis), b);
  return eye * exact_.side(Plane::along_axis(a, b, axis), projected_.point(edge_on.apex)) == Sign::positive;
}

}  // namespace hsr::internal
