#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr {

namespace internal {
struct BspNodes;
}  // namespace internal

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
/// @throws InputError beyond the most pieces, or 2^32 - 1 corners
/// Exact: yes. Cost: build O(n log n) where planes divide well, O(n^2) pieces at worst, never recursive; an order is linear in
/// the pieces. Source: Fuchs, Kedem & Naylor 1980; axis-parallel cuts as in k-d trees, Bentley 1975.
class BspTree {
 public:
  explicit BspTree(const Mesh& mesh, const BspOptions& options = {});

  /// The pieces beyond the near plane, far to near; none of faces seen edge-on.
  /// @throws InputError beyond 2^32 - 1 corners
  PaintersOrder order(const View& view) const;
  /// @pre the scene is of the mesh that the tree was built of
  /// @throws InputError beyond 2^32 - 1 corners
  PaintersOrder order(const SceneView& scene) const;
  /// The numbers of the pieces far to near, those of faces seen edge-on included: the walk alone. Cost: some ns a piece.
  void walk(const View& view, std::vector<std::uint32_t>& far_to_near, TieRule ties = {}) const;

  std::size_t nodes() const;
  std::size_t depth() const;
  std::size_t pieces() const;
  std::uint64_t splits() const;
  const DecisionCounts& decisions() const;

 private:
  std::shared_ptr<const internal::BspNodes> nodes_;  // never changed, and so shared by copies
};

}  // namespace hsr
