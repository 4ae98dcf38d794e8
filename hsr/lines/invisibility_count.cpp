#include "hsr/lines/invisibility_count.h"

#include "hsr/scene/line_filter.h"

namespace hsr::internal {

/// p lies strictly beyond the plane of t: the eye is on the side `facing`.
bool InvisibilityCount::hides(TriangleId t, VertexId p) {
  return projected_.side(projected_.face_plane(t), p, exact_) == -projected_.facing(t);
}

std::int32_t InvisibilityCount::at_vertex(VertexId v, VertexId to, Sign side) {
  const LineFilter line(projected_, v, to);
  // What is seen exactly on the edge lies to the other side of a point that is moved to this one.
  const auto moved = [&](VertexId p) {
    const Sign s = line.side(p, exact_);
    return s != Sign::zero ? s : -side;
  };
  std::int32_t count = 0;
  for (const TriangleId t : layers_.star(v)) {
    const auto& c = projected_.mesh().triangles[t];
    const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    const VertexId first = c[(k + 1) % 3], second = c[(k + 2) % 3];
    if (first == to || second == to) continue;  // nothing hides in its own plane
    const Sign facing = projected_.facing(t);
    if (moved(first) * facing == Sign::negative && moved(second) * facing == Sign::positive && hides(t, to)) ++count;
  }
  return count;
}

std::int32_t InvisibilityCount::before(VertexId v, VertexId to, Sign side, const Occluders& occluders) {
  std::int32_t count = 0;
  occluders.tree.visit(projected_.box(v, v), [&](std::uint32_t i) {
    const TriangleId t = occluders.triangles[i];
    const auto& c = projected_.mesh().triangles[t];
    if (!layers_.counts(t) || c[0] == v || c[1] == v || c[2] == v) return true;
    const Sign facing = projected_.facing(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const LineFilter line(projected_, c[k], c[(k + 1) % 3]);
      Sign inner = line.side(v, exact_) * facing;
      if (inner == Sign::zero) inner = line.side(to, exact_) * facing;
      // The edge is seen along this side: inside iff the triangle lies to the side that the point was moved to.
      if (inner == Sign::zero) inner = LineFilter(projected_, v, to).side(c[(k + 2) % 3], exact_) * side;
      if (inner == Sign::negative) return true;
    }
    if (hides(t, v)) ++count;
    return true;
  });
  return count;
}

}  // namespace hsr::internal
