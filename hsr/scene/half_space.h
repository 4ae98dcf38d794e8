#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "geometry/error.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// A plane through a side of a triangle, across the triangle's own plane, and the side of it on which the triangle lies.
struct HalfSpace {
  Cut cut;
  Plane plane;
  Sign inner = Sign::positive;
};

/// A coordinate that may be dropped from the triangle's plane: the triangle keeps an area in the other two.
inline int dropped_axis(const ProjectedMesh& projected, TriangleId t, Predicates& exact) {
  const auto& c = projected.mesh().triangles[t];
  for (int axis = 0; axis < 3; ++axis)
    if (exact.side(Plane::along_axis(projected.point(c[0]), projected.point(c[1]), axis), projected.point(c[2])) != Sign::zero)
      return axis;
  throw InvariantError("HalfSpace: a triangle of no area");
}

/// The half-spaces whose common part with the plane of a triangle is the triangle; side k is the one from corner k to the next.
/// They are bounded by view planes, and where the triangle is seen edge-on by planes parallel to an axis.
inline std::array<HalfSpace, 3> half_spaces(const ProjectedMesh& projected, TriangleId t, Predicates& exact) {
  const auto& c = projected.mesh().triangles[t];
  const Sign facing = projected.facing(t);
  const bool edge_on = facing == Sign::zero;
  const int axis = edge_on ? dropped_axis(projected, t, exact) : 0;
  std::array<HalfSpace, 3> all;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = std::min(c[k], c[(k + 1) % 3]), v = std::max(c[k], c[(k + 1) % 3]);
    HalfSpace& h = all[k];
    h.cut = {edge_on ? Cut::Kind::line : Cut::Kind::sight, static_cast<std::uint8_t>(axis), u.value, v.value};
    if (edge_on) {
      h.plane = Plane::along_axis(projected.point(u), projected.point(v), axis);
      h.inner = exact.side(h.plane, projected.point(c[(k + 2) % 3]));
    } else {
      // O(u, v, .) changes its sign with the order of u and v.
      h.plane = projected.sight_plane(u, v);
      h.inner = u == c[k] ? facing : -facing;
    }
  }
  return all;
}

}  // namespace hsr::internal
