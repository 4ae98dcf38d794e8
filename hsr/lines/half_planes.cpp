#include "hsr/lines/half_planes.h"

#include <algorithm>

#include "hsr/scene/facet.h"
#include "hsr/scene/half_space.h"

namespace hsr::internal {

void ExactHalfPlanes::add(const EdgeContact& contact) {
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
    add(contact.triangle, c[k], edge_on ? Sign::zero : s);
  }
}

void ExactHalfPlanes::add(TriangleId triangle, VertexId apex, Sign side) {
  HalfPlane added{triangle, apex, side, false, projected_.mesh().face_of[triangle]};
  for (HalfPlane& h : all_) {
    if (!coincide(h, added)) continue;
    share(h, added.face);
    return;
  }
  if (side == Sign::zero) added.is_front = starts_toward_eye(added);
  all_.push_back(added);
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
