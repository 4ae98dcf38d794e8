#include "hsr/visibility_map/convex_ring.h"

#include <algorithm>

#include "hsr/scene/facet.h"
#include "hsr/scene/half_space.h"

namespace hsr::internal {

namespace {

struct RingSide {
  VertexId from, to;
};

}  // namespace

std::vector<VertexId> convex_ring(const ProjectedMesh& projected, FacetId facet, Predicates& exact) {
  const Mesh& mesh = projected.mesh();
  const TriangleId end = facet_end(mesh, facet);
  const auto& c = mesh.triangles[first_triangle(facet)];
  if (triangle_count(mesh, facet) == 1) return {c.begin(), c.end()};
  std::vector<RingSide> sides;
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U)) {
    const auto& corners = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (!is_inner_diagonal(mesh, t, k)) sides.push_back({corners[k], corners[(k + 1) % 3]});
  }
  if (sides.size() != triangle_count(mesh, facet) + 2U) return {};  // a hole, or parts that only touch
  const auto from = [&](VertexId v) {
    return std::find_if(sides.begin(), sides.end(), [&](const RingSide& s) { return s.from == v; });
  };
  std::vector<VertexId> ring;
  for (VertexId at = sides.front().from; ring.size() < sides.size();) {
    const auto side = from(at);
    if (side == sides.end() || (!ring.empty() && at == ring.front())) return {};
    ring.push_back(at);
    at = side->to;
  }
  if (from(ring.back())->to != ring.front()) return {};
  // Every turn as the first triangle turns, or none.
  const int axis = dropped_axis(projected, first_triangle(facet), exact);
  const auto turn = [&](VertexId u, VertexId v, VertexId w) {
    return exact.side(Plane::along_axis(projected.point(u), projected.point(v), axis), projected.point(w));
  };
  const Sign inner = turn(c[0], c[1], c[2]);
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (turn(ring[k], ring[(k + 1) % ring.size()], ring[(k + 2) % ring.size()]) * inner == Sign::negative) return {};
  return ring;
}

}  // namespace hsr::internal
