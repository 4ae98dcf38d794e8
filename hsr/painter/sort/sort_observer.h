#pragma once

#include <cstdint>
#include <span>

#include "hsr/painter/sort/clusters.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/face_pieces.h"
#include "hsr/painter/sort/overlap.h"

namespace hsr::internal {

/// Which of Newell's tests told how two pieces lie, in the order in which they are asked.
enum class SortTest : std::uint8_t {
  image_sides,      ///< a side of one has all of the other beyond it in the image: they do not overlap
  depths,           ///< all of one is nearer than all of the other
  plane_of_first,   ///< the second lies on one side of the plane of the first
  plane_of_second,  ///< the first lies on one side of the plane of the second
  coplanar,         ///< the two lie in one plane
  common_part,      ///< only where their images overlap is one of them nearer, or each is somewhere
};

/// Is told what depth sort does, in the order in which it does it. Pieces are numbers: first those of FacePieces, then the parts that
/// cuts leave, each cut two.
class SortObserver {
 public:
  SortObserver() = default;
  SortObserver(const SortObserver&) = delete;
  SortObserver& operator=(const SortObserver&) = delete;
  virtual ~SortObserver() = default;

  /// @param clusters pieces of two of them are never compared
  virtual void began(const FacePieces& pieces, const Clusters& clusters) = 0;
  /// The pieces from far to near by their keys, a first guess.
  virtual void sorted(std::span<const std::uint32_t> pieces) = 0;
  virtual void compared(std::uint32_t first, std::uint32_t second, SortTest decided_by, Overlap how) = 0;
  /// A piece is looked at; early: for one that it is behind, before its turn.
  virtual void opened(std::uint32_t piece, bool is_early) = 0;
  /// All that is behind a piece has been painted, and now it is.
  virtual void painted(std::uint32_t piece) = 0;
  /// The search came back to a piece that waits for others: there is a cycle, or too much comes early.
  virtual void met_again(std::uint32_t piece) = 0;
  /// No order of whole pieces was found: now all pairs are related, and something may be cut.
  virtual void relates_all() = 0;
  virtual void found_cycle(std::span<const std::uint32_t> pieces) = 0;
  /// A piece is cut along a line of the image; its parts are numbers `first` and `first` + 1.
  virtual void cut(std::uint32_t piece, std::uint32_t first, const PieceOfFacet& inside, const PieceOfFacet& outside,
                   const MapLine& line) = 0;
  virtual void found_piercing(std::uint32_t first, std::uint32_t second) = 0;
  /// A part that was cut, and a neighbour of the whole.
  virtual void related(std::uint32_t part, std::uint32_t other, Overlap how) = 0;
  /// Pieces are ordered by planes at once, and painted as one.
  virtual void ordered_by_planes(std::span<const std::uint32_t> pieces, const PaintersOrder& block) = 0;
  /// The end: the pieces from far to near. A number beyond all pieces is that of a block, less `blocks_from`.
  virtual void ordered(std::span<const std::uint32_t> pieces, std::uint32_t blocks_from) = 0;
};

/// depth_sort(), watched, in one thread: it does the same and gives the same. @pre the view has no cells, the mesh a triangle
DepthSort depth_sort(const SceneView& scene, const DepthSortOptions& options, SortObserver& observer);

}  // namespace hsr::internal
