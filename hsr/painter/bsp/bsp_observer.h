#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hsr/painter/painters_order.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// How a plane would divide the parts of a node, and what that costs: the least is taken.
struct BspScore {
  std::size_t behind = 0, before = 0;  ///< wholly on a side, or cut
  std::size_t cut = 0;                 ///< of them, in both
  std::size_t score = 0;
};

/// Is told how a BspTree is built and walked, in the order in which that is done. Parts are numbers: first those of the faces, then what
/// splits leave; the pieces of the tree are numbered as nodes take their parts.
class BspObserver {
 public:
  BspObserver() = default;
  BspObserver(const BspObserver&) = delete;
  BspObserver& operator=(const BspObserver&) = delete;
  virtual ~BspObserver() = default;

  /// A part of a face, before anything is divided. @param corners as the face runs
  virtual void added_part(std::uint32_t part, FacetId facet, std::span<const PieceCorner> corners) = 0;
  /// A node is to be divided. @param parent meaningless of the root
  virtual void opened(std::span<const std::uint32_t> parts, std::uint32_t parent, bool is_before) = 0;
  /// The plane of a face was tried; of a large node planes are tried on some of its parts, and only the one that is taken is told.
  virtual void tried(const Cut& plane, const BspScore& score) = 0;
  virtual void split(std::uint32_t part, std::uint32_t behind, std::span<const PieceCorner> corners_behind,
                     std::uint32_t before, std::span<const PieceCorner> corners_before) = 0;
  /// A node with the parts that lie in its plane, ascending by facet.
  virtual void added_node(std::uint32_t node, std::uint32_t parent, bool is_before, const Cut& plane,
                          std::span<const std::uint32_t> inside) = 0;
  /// The walk comes to a node: what is on the other side of its plane than the viewer is next.
  virtual void walked(std::uint32_t node, bool is_leaf, bool viewer_is_before) = 0;
  /// The pieces of a node are painted.
  virtual void visited(std::uint32_t first_piece, std::uint32_t end_piece) = 0;
};

}  // namespace hsr::internal
