#pragma once

#include <cstdint>
#include <optional>

#include "hsr/visibility_map/convex_piece.h"

namespace hsr::internal {

/// How two pieces lie where their images overlap.
enum class Overlap : std::uint8_t {
  none,          ///< the interiors of their images have no point in common
  first_behind,  ///< the first is nowhere nearer: it is painted first
  second_behind,
  piercing,  ///< each is nearer somewhere
};

/// How often each of Newell's tests decided.
struct OverlapCounts {
  std::uint64_t image_sides = 0;    ///< a side of one separates their images
  std::uint64_t depths = 0;         ///< one is nearer than all of the other
  std::uint64_t first_planes = 0;   ///< the second lies on one side of the first's plane
  std::uint64_t second_planes = 0;  ///< the first lies on one side of the second's plane
  std::uint64_t coplanar = 0;       ///< they lie in one plane
  std::uint64_t intersection = 0;   ///< only where their images overlap is one of them the nearer

  OverlapCounts& operator+=(const OverlapCounts& o);
  friend bool operator==(const OverlapCounts&, const OverlapCounts&) = default;
};

/// Where one piece is nearer than another, and where farther: on some lines of sight that tell.
struct Sides {
  bool nearer = false, farther = false;

  void add(Sign s) {
    nearer = nearer || s == Sign::positive;
    farther = farther || s == Sign::negative;
  }
};

/// Where a corner of a piece is seen, and where it is on its facet, each within a proven bound; infinite: not known. Not a
/// BoundedPoint2: the turn of corners is computed with a bound for each coordinate.
struct NearCorner {
  ErrorBounded x, y;  ///< in the image (MapPlace)
  BoundedPoint3 on_facet;
};

/// A convex piece of a facet that is not seen edge-on.
struct PieceOfFacet {
  FacetId facet;
  ConvexPiece shape = {};             ///< empty: as FacePieces has it, and not asked for
  std::vector<NearCorner> near = {};  ///< by corner (Overlaps::near_corners); or empty: not asked for
};

/// The relation of pieces by the tests of Newell, Newell & Sancha, each exact. One object per thread.
///
/// Of coplanar pieces that overlap the one on top (TieRule) is painted last. Touching is no overlap. Where corners are
/// known within bounds that settle a sign, doubles decide; the symbols decide the others. Exact: yes. Cost: some signs of
/// degree 3 mostly. Source: Newell, Newell & Sancha 1972.
class Overlaps {
 public:
  /// @param classic call piercing every pair that no plane of the two separates, as the paper does
  explicit Overlaps(const ProjectedMesh& projected, bool classic = false)
      : map_(projected), projected_(projected), classic_(classic) {}

  Overlap relation(const PieceOfFacet& a, const PieceOfFacet& b);
  /// Whether the interiors of their images have a point in common.
  bool have_common_part(const PieceOfFacet& a, const PieceOfFacet& b) { return !separates(a, b) && !separates(b, a); }
  /// Where the corners of a piece are, for relations of pieces that have been cut.
  std::vector<NearCorner> near_corners(const PieceOfFacet& piece) const;
  /// The common part of their images, if it has an inside.
  std::optional<ConvexPiece> common_part(const PieceOfFacet& a, const PieceOfFacet& b);

  MapPredicates& map() { return map_; }
  const OverlapCounts& counts() const { return counts_; }

 private:
  bool separates(const PieceOfFacet& a, const PieceOfFacet& b);
  ErrorBounded side(const PieceOfFacet& piece, std::size_t k, const NearCorner& p) const;
  ErrorBounded beyond(FacetId facet, const NearCorner& p) const;
  Sign nearer(const PieceOfFacet& a, const PieceOfFacet& b, std::size_t corner, bool is_of_a);
  Sides sides(const PieceOfFacet& a, const PieceOfFacet& b, bool are_of_a);
  std::optional<Sides> near_sides(const PieceOfFacet& a, const PieceOfFacet& b);

  MapPredicates map_;
  const ProjectedMesh& projected_;
  bool classic_;
  OverlapCounts counts_;
};

}  // namespace hsr::internal
