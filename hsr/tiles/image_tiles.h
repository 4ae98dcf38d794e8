#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A side of tiles that bounds one of them, and on which side of it the tile lies.
struct TileBound {
  std::uint32_t side;
  Sign kept;
};

/// The image in tiles, whose sides are view planes: a tree that halves the image again and again.
///
///   (1) every point of space is in a tile, and in several only if it lies in a side: so is everything that hides it, as each side
///       holds whole lines of sight
///   (2) a side is named by two points of it, and never rounded
struct ImageTiles {
  /// The view plane of two points.
  struct Side {
    Point3 c, d;
  };
  /// What a side parts: another split, or the tile ~n.
  struct Split {
    std::int32_t negative = 0, positive = 0;
  };
  std::vector<Side> sides;    ///< by split
  std::vector<Split> splits;  ///< the first is the root; none: one tile

  std::uint32_t count() const { return static_cast<std::uint32_t>(splits.size()) + 1; }
  /// What bounds a tile, from the root on. @pre tile < count()
  std::vector<TileBound> bounds(std::uint32_t tile) const;
};

/// The place of a point in the view's frame, in doubles; not finite: it has none.
Point2 place_in_frame(const View& view, const Point3& p);

/// The side x = at of the view's frame, or with axis 1 y = at, by points of few bits, so that no exact sign takes wider numbers for it.
/// @param size of the picture
ImageTiles::Side tile_side(const View& view, int axis, double at, double size);

/// Tiles in each of which lie about as many of these places of the frame. @pre count > 0
ImageTiles balanced_tiles(const View& view, std::vector<Point2> places, std::uint32_t count);

/// Finds the tiles that polygons may reach into: those of which no one side has the polygon strictly behind it.
/// Exact: yes. Cost: a sign of degree 3 for each corner and side that is looked at.
class TileFinder {
 public:
  /// @param points bit range of all corners
  TileFinder(const ImageTiles& tiles, const View& view, BitRange points);
  /// Appends the tiles, ascending in the order of the tree.
  void find(std::span<const Point3> corners, std::vector<std::uint32_t>& found);

 private:
  const ImageTiles& tiles_;
  std::vector<Plane> planes_;
  Predicates exact_;
  std::vector<std::int32_t> open_;
};

}  // namespace hsr::internal
