#pragma once

#include <span>
#include <vector>

#include "hsr/lines/occluders.h"
#include "hsr/surfaces/map_sight.h"
#include "hsr/surfaces/triangle_sides.h"

namespace hsr {

/// A part of a line of the map, and the triangle that is seen just beside it; none: nothing is.
struct SeenPart {
  MapPoint from, to;  ///< along the line
  TriangleId seen;
};

/// Which triangle is seen just beside a part of a line: the lower envelope of the faces over it. One object per thread.
///
/// "Just beside" settles what coincides in the image: a triangle that ends at the line is there on its own side only; of two
/// that meet in the line the one that is nearer beside it is seen; of two in one plane the lower index.
/// Exact: yes. Cost: O(k m) signs for the k triangles that overlap the part and m parts. Source: Hart & Sharir 1986 (envelopes of
/// segments), here of faces over a line.
class SeenBeside {
 public:
  SeenBeside(MapSight& map, const Occluders& occluders) : map_(map), occluders_(occluders) {}

  /// @param box around the part in the image; its depths do not matter
  /// @param side positive, to the left of the line; the answer holds until the next call
  std::span<const SeenPart> find(const MapLine& line, const MapPoint& from, const MapPoint& to, const ImageBox& box, Sign side);

 private:
  void insert(TriangleId t);
  bool clip(TriangleId t, MapPoint& from, MapPoint& to);
  bool clip(const MapHalfPlane& h, MapPoint& from, MapPoint& to);
  Sign nearer_beside(TriangleId s, TriangleId t);
  void add(const MapPoint& from, const MapPoint& to, TriangleId t);

  MapSight& map_;
  const Occluders& occluders_;
  MapLine line_;
  Sign side_ = Sign::positive;
  std::vector<SeenPart> parts_, next_;
};

}  // namespace hsr
