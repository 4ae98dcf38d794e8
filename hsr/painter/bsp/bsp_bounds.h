#pragma once

#include <cstdint>
#include <vector>

#include "geometry/error.h"
#include "hsr/painter/painters_order.h"

namespace hsr::internal {

/// The planes that bound the pieces of a BSP, each named by 32 bits: then a corner takes 12 bytes, not the 44 of a PieceCorner.
class BspBounds {
 public:
  using Id = std::uint32_t;
  static constexpr Id none = 0xffffffffU;

  /// A corner of a piece, and the side that leaves it.
  struct Corner {
    Id a, b;  ///< the planes that meet the facet's in it; b none: it is the vertex a
    Id side;

    bool is_vertex() const { return b == none; }
  };
  /// A plane through two vertices, u < v, parallel to an axis.
  struct Side {
    VertexId u, v;
    std::uint8_t axis = 0;
    bool original = false;  ///< an edge of the face
  };

  static Id facet(FacetId f) { return f.value; }  // a mesh has fewer than 2^30 triangles
  static bool is_side(Id id) { return (id & kinds) == side_kind; }
  static bool is_across(Id id) { return (id & kinds) == across_kind; }
  static std::uint32_t place(Id id) { return id & ~kinds; }
  static Id across(std::size_t place) { return across_kind | static_cast<Id>(place); }

  /// @throws InputError if there are too many
  Id add(const Side& side) {
    sides.push_back(side);
    return side_kind | counted(sides.size() - 1);
  }
  Id add_across(const Cut& cut) {
    acrosses.push_back(cut);
    return across_kind | counted(acrosses.size() - 1);
  }

  std::vector<Side> sides;
  std::vector<Cut> acrosses;  ///< planes across an axis

 private:
  static constexpr Id kinds = 3U << 30U, across_kind = 1U << 30U, side_kind = 2U << 30U;

  static Id counted(std::size_t place) {
    if (place >= std::size_t{1} << 30U) throw InputError("fewer than 2^30 planes that bound pieces of a BSP expected");
    return static_cast<Id>(place);
  }
};

/// @param sides of all pieces @param acrosses those that the corner knows
inline Cut cut_of(BspBounds::Id id, const std::vector<BspBounds::Side>& sides, const std::vector<Cut>& acrosses) {
  if (BspBounds::is_across(id)) return acrosses[BspBounds::place(id)];
  if (!BspBounds::is_side(id)) return {Cut::Kind::face, 0, id, 0};
  const BspBounds::Side& side = sides[BspBounds::place(id)];
  return {Cut::Kind::line, side.axis, side.u.value, side.v.value};
}

}  // namespace hsr::internal
