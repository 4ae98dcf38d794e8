#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/plane_filter.h"
#include "hsr/painter/bsp/bsp_bounds.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr {

struct BspOptions {
  std::uint64_t seed = 1;       ///< of the planes that are tried; the same seed gives the same tree
  std::size_t most_pieces = 0;  ///< beyond it the scene is refused; 0: a million, or 64 a face
};

/// A tree of planes that orders the faces of a scene from any viewpoint: built once, walked for each.
///
/// Each node's plane divides the pieces below it: some lie in the plane, the others in front of it or behind it. Large nodes
/// are cut square to an axis at a vertex near the middle, small ones by the plane of one of their faces; of a few the one that
/// cuts least and divides best. Pieces are bounded by planes of the scene, never by rounded points.
///
///   (1) order(view) is a painter's order (docs/conventions.md): along every line of sight the farther piece comes first
///   (2) the pieces of a face cover it exactly once
///   (3) the same tree for the same seed, and for any number of threads
///
/// @throws InputError beyond the most pieces
/// Exact: yes. Cost: build O(n log n) where planes divide well, O(n^2) pieces at worst, never recursive; an order is linear in
/// the pieces. Source: Fuchs, Kedem & Naylor 1980; axis-parallel cuts as in k-d trees, Bentley 1975.
class BspTree {
 public:
  explicit BspTree(const Mesh& mesh, const BspOptions& options = {});

  /// The pieces beyond the near plane, far to near; none of faces seen edge-on.
  PaintersOrder order(const View& view) const { return order(SceneView(*mesh_, view)); }
  /// @pre the scene is of the mesh that the tree was built of
  PaintersOrder order(const SceneView& scene) const;
  /// The numbers of the pieces far to near, those of faces seen edge-on included: the walk alone. Cost: some ns a piece.
  void walk(const View& view, std::vector<std::uint32_t>& far_to_near) const;

  std::size_t nodes() const { return nodes_.size(); }
  std::size_t depth() const { return depth_; }
  std::size_t pieces() const { return pieces_.size(); }
  std::uint64_t splits() const { return splits_; }
  const DecisionCounts& decisions() const { return decisions_; }

 private:
  friend class BspBuilder;
  BspTree() = default;
  struct Node {
    Cut plane;
    std::uint32_t behind = 0, before = 0;          ///< children on the negative and the positive side; 0: nothing
    std::uint32_t first_piece = 0, end_piece = 0;  ///< in the plane, ascending by facet
    std::uint32_t filter = 0;                      ///< of a facet's plane that has something on a side

    bool is_leaf() const { return behind == 0 && before == 0; }
  };

  void prepare_planes();
  PieceCorner corner(const BspBounds::Corner& c) const;

  const Mesh* mesh_ = nullptr;
  BitRange bit_range_;                // of the points
  std::vector<PlaneFilter> filters_;  // of planes of nodes, for eyes
  std::vector<Node> nodes_;           // the root first
  std::vector<OrderedPiece> pieces_;  // in the order of the nodes; corners as the face runs
  std::vector<BspBounds::Corner> corners_;
  BspBounds bounds_;
  std::size_t depth_ = 0;
  std::uint64_t splits_ = 0;
  DecisionCounts decisions_;
};

}  // namespace hsr
