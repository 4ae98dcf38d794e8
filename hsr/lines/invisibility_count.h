#pragma once

#include <cstdint>

#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// Quantitative invisibility just inside an edge: how many counted triangles are strictly in front of a point of the edge next
/// to its vertex v. The point is moved from v a little along the edge, and then, much less, to one side: so its image never
/// lies on the border of a triangle.
/// Exact: yes, where the edge touches nothing in space.
class InvisibilityCount {
 public:
  InvisibilityCount(const ProjectedMesh& projected, const OccludingEdges& layers)
      : projected_(projected), layers_(layers), exact_(projected.predicates()) {}

  /// Of the triangles at v. @param to the other vertex of the edge @param side positive, moved to the left of v -> to
  std::int32_t at_vertex(VertexId v, VertexId to, Sign side);
  /// Of all others.
  std::int32_t before(VertexId v, VertexId to, Sign side, const Occluders& occluders);

  const DecisionCounts& decisions() const { return exact_.counts(); }

 private:
  bool hides(TriangleId t, VertexId p);

  const ProjectedMesh& projected_;
  const OccludingEdges& layers_;
  Predicates exact_;
};

}  // namespace hsr::internal
