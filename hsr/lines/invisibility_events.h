#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

class LineFilter;

/// A place inside an edge where the number of triangles in front of it changes, going from a to b: by `left` just to the left
/// of the edge, by `right` just to the right. The two differ where the image of an occluding edge ends exactly on the edge.
struct InvisibilityChange {
  std::uint32_t by;  ///< an EdgeId; of a pierced face, a TriangleId
  bool is_face;
  std::int32_t left, right;
};

/// What happens along one edge on the way from its vertex a to b.
struct EdgeWalk {
  bool is_point = false;       ///< the image of the edge is a point
  bool is_hidden = false;      ///< the edge is known to be hidden, and was not followed
  bool is_degenerate = false;  ///< it touches something in space, or crosses the near plane, so that counting cannot decide
  /// No occluding edge, except those incident to a, passes in front of a or through it. The number of triangles in front of a,
  /// without those at a, is then the same for all edges at a.
  bool start_is_clean = true;
  bool end_is_clean = true;          ///< as start_is_clean, for b
  std::int32_t left = 0, right = 0;  ///< the sums of the changes

  bool is_followed() const { return !is_point && !is_hidden && !is_degenerate; }
};

/// Finds where the number of triangles in front of an edge (its quantitative invisibility) changes. One object per thread.
///
/// "Just to the left" settles every coincidence in the image: an end of an occluding edge that is seen exactly on the edge lies
/// to the right of what is just to the left of it, and to the left of what is just to the right. In space nothing is settled
/// that way: an edge that touches an occluding edge, or the side or corner of a face, is degenerate.
/// Exact: yes. Source: Appel 1967.
class InvisibilityEvents {
 public:
  InvisibilityEvents(const ProjectedMesh& projected, const OccludingEdges& layers, const Occluders& occluders)
      : projected_(projected), layers_(layers), occluders_(occluders), exact_(projected.predicates()) {}

  /// Turns to a few edges that are near one another in the image: the search is then shared.
  void turn_to(std::span<const ImageBox> boxes);
  /// Appends the changes along the edge, in no order. @pre `box` is the edge's, one of those turned to
  EdgeWalk find(EdgeId edge, const ImageBox& box, std::vector<InvisibilityChange>& changes);

  const DecisionCounts& decisions() const { return exact_.counts(); }
  std::uint64_t pairs() const { return pairs_; }

 private:
  void cross(const Edge& edge, const OccludingEdge& occluding, std::vector<InvisibilityChange>& changes);
  void pierce_faces(const Edge& edge, const ImageBox& box, std::vector<InvisibilityChange>& changes);
  void pierce(const Edge& edge, TriangleId t, std::vector<InvisibilityChange>& changes);
  void add(InvisibilityChange change, std::vector<InvisibilityChange>& changes);

  const ProjectedMesh& projected_;
  const OccludingEdges& layers_;
  const Occluders& occluders_;
  Predicates exact_;
  std::uint64_t pairs_ = 0;
  std::size_t leaves_ = 0, boxes_ = 0;  // of faces that were looked at
  // The leaves that may matter to the edges turned to; if they are too many, each edge looks for its own.
  std::vector<std::uint32_t> edge_leaves_, face_leaves_;
  bool shares_edge_leaves_ = false, shares_face_leaves_ = false;
  const LineFilter* line_ = nullptr;
  EdgeWalk course_;
};

}  // namespace hsr::internal
