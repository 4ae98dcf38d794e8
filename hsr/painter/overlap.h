#pragma once

#include <cstdint>
#include <optional>

#include "hsr/map/convex_piece.h"

namespace hsr {

/// How two pieces lie where their images overlap.
enum class Overlap : std::uint8_t {
  none,          ///< the interiors of their images have no point in common
  first_behind,  ///< the first is nowhere nearer: it is painted first
  second_behind,
  piercing,  ///< each is nearer somewhere
};

/// How often each of Newell's tests decided.
struct OverlapCounts {
  std::uint64_t image_sides = 0;   ///< a side of one separates their images
  std::uint64_t planes = 0;        ///< one lies on one side of the other's plane
  std::uint64_t coplanar = 0;      ///< they lie in one plane
  std::uint64_t intersection = 0;  ///< only where their images overlap is one of them the nearer

  OverlapCounts& operator+=(const OverlapCounts& o);
  friend bool operator==(const OverlapCounts&, const OverlapCounts&) = default;
};

/// A convex piece of a facet that is not seen edge-on.
struct PieceOfFacet {
  TriangleId facet;
  ConvexPiece shape;
};

/// The relation of pieces by the tests of Newell, Newell & Sancha, each exact. One object per thread.
///
/// Of coplanar pieces that overlap the one of the higher facet is painted first. Touching is no overlap.
/// Exact: yes. Cost: some signs of degree 3 mostly. Source: Newell, Newell & Sancha 1972.
class Overlaps {
 public:
  /// @param classic call piercing every pair that no plane of the two separates, as the paper does
  explicit Overlaps(const Sight& sight, bool classic = false) : map_(sight), sight_(sight), classic_(classic) {}

  Overlap relation(const PieceOfFacet& a, const PieceOfFacet& b);
  /// The common part of their images, if it has an inside.
  std::optional<ConvexPiece> common_part(const PieceOfFacet& a, const PieceOfFacet& b);

  MapSight& map() { return map_; }
  const OverlapCounts& counts() const { return counts_; }

 private:
  bool separates(const PieceOfFacet& a, const PieceOfFacet& b);
  Sign nearer(const PieceOfFacet& a, const PieceOfFacet& b, const MapPoint& p, bool is_of_a);
  struct Sides {
    bool nearer = false, farther = false;
  };
  Sides sides(const PieceOfFacet& a, const PieceOfFacet& b, const std::vector<MapPoint>& points, bool are_of_a);

  MapSight map_;
  const Sight& sight_;
  bool classic_;
  OverlapCounts counts_;
};

}  // namespace hsr
