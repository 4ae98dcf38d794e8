#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/plane_filter.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/bsp/bsp_bounds.h"
#include "hsr/painter/painters_order.h"

namespace hsr::internal {

class BspObserver;
class ProjectedMesh;

/// What a BspTree is made of; while it is built, also what one of its subtrees is made of.
struct BspNodes {
  struct Node {
    Cut plane;
    std::uint32_t behind = 0, before = 0;          ///< children on the negative and the positive side; 0: nothing
    std::uint32_t first_piece = 0, end_piece = 0;  ///< in the plane, ascending by facet
    std::uint32_t filter = 0;                      ///< of a facet's plane that has something on a side

    bool is_leaf() const { return behind == 0 && before == 0; }
  };

  const Mesh* mesh = nullptr;
  BitRange bit_range;                ///< of the points
  std::vector<PlaneFilter> filters;  ///< of planes of nodes, for eyes
  std::vector<Node> nodes;           ///< the root first
  std::vector<OrderedPiece> pieces;  ///< in the order of the nodes; corners as the face runs
  std::vector<BspBounds::Corner> corners;
  BspBounds bounds;
  std::size_t depth = 0;
  std::uint64_t splits = 0;
  DecisionCounts decisions;

  /// Bit range and filters, once all nodes are there.
  void prepare_planes();
  PieceCorner corner(const BspBounds::Corner& c) const;
};

/// Some facets of a mesh, for a method that orders the rest itself.
struct SomeFacets {
  std::span<const FacetId> facets;  ///< ascending
  std::size_t pieces_before = 0;    ///< that the method has made, of the most that are allowed
  const char* method = "";          ///< its name, for what is refused
  std::stop_token stop = {};        ///< once it is asked to stop, building ends in a CancelledError
};

/// The tree of a mesh, or of some facets of it, without what prepare_planes() makes. @throws InputError beyond the most pieces
/// @param observer is told how; null: nobody is
BspNodes build_nodes(const Mesh& mesh, const BspOptions& options, const SomeFacets* some = nullptr,
                     BspObserver* observer = nullptr);

/// Appends the pieces of a tree as a view has them, far to near. @pre prepare_planes() was called
void append_far_to_near(const BspNodes& tree, const ProjectedMesh& projected, const View& view, PaintersOrder& order,
                        BspObserver* observer = nullptr);

}  // namespace hsr::internal
