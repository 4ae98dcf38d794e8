#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// An edge at whose image the number of triangles over an image point changes.
struct OccludingEdge {
  EdgeId edge;
  std::int32_t weight;  ///< triangles to the left of a -> b in the image, minus triangles to the right; never zero
};

/// Which triangles quantitative invisibility counts, as layers over the image, and the edges at which their number changes.
///
/// Counted is a triangle that is not seen edge-on, of a face that lies wholly on or beyond the near plane. The layers over two
/// image points differ by the weights of the edges crossed on the way (Appel 1967): outlines and boundaries, and edges of many
/// faces.
///
/// A triangle seen edge-on hides nothing that the counted ones do not, unless it is `cast`: on the way toward the eye the line
/// of sight leaves the edge-on triangles of its plane through a side of one of them; where a counted triangle has that side,
/// too, it hides as much. Cast, one by one as `roberts` does, are the others: with a side that no counted triangle has, and
/// where no triangle of the same plane goes on; and those of faces that the near plane cuts. Where such a side, or such a
/// triangle, is left out because it is hidden, so is what it would hide. Where it is the far side of a body, the line of sight
/// comes out of the body there and has entered it through a triangle that is not left out.
///
/// Exact: yes. Cost: O(n), parallel, and O(m log m) for m occluding edges.
class OccludingEdges {
 public:
  /// @param left_out by triangle, because it is hidden itself or a far side (ClosedBodies); whole faces only; empty: none
  OccludingEdges(const ProjectedMesh& projected, const std::vector<std::uint8_t>& left_out);

  bool counts(TriangleId t) const { return counts_[t] != 0; }
  const std::vector<OccludingEdge>& edges() const { return edges_; }
  const BoxTree& tree() const { return tree_; }  ///< over edges()
  const std::vector<TriangleId>& cast() const { return cast_; }
  const BoxTree& cast_tree() const { return cast_tree_; }  ///< over cast()

  /// Exactly one layer of counted triangles lies around the image of v, each next to the one before, and every edge at v that
  /// is seen as a line is between two of them: no triangle at v hides a part of an edge at v near v.
  bool is_plain(VertexId v) const { return is_plain_[v.value] != 0; }
  /// The counted triangles at a vertex that is not plain.
  std::span<const TriangleId> star(VertexId v) const { return stars_[v.value]; }

 private:
  bool is_left_out(TriangleId t) const { return !left_out_.empty() && left_out_[t.value] != 0; }
  void choose_counted();
  void weigh_edges();
  void find_stars();
  bool near_cuts_face(TriangleId t) const;
  bool needs_cast(TriangleId t, EdgeId e, Predicates& exact) const;

  const ProjectedMesh& projected_;
  const std::vector<std::uint8_t>& left_out_;
  IndexedVector<TriangleId, std::uint8_t> counts_;
  std::vector<OccludingEdge> edges_;
  BoxTree tree_;
  std::vector<TriangleId> cast_;
  BoxTree cast_tree_;
  std::vector<std::uint8_t> is_plain_;  // by VertexId
  Ragged<TriangleId> stars_;            // by VertexId
};

}  // namespace hsr::internal
