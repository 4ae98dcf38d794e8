#pragma once

#include <vector>

#include "geometry/number.h"
#include "hsr/symbols/map_point.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

/// Cuts parts of the map off at lines. One object per thread.
class MapClipper {
 public:
  explicit MapClipper(MapPredicates& map) : map_(map) {}

  /// Leaves of the part of the map that the sides bound, which is on their left, what is on one side of the line. Where the part goes on
  /// beyond the line it is bounded by a side along the line; a side that ran there before keeps its name.
  /// @pre the sides bound a part of the map, and none lies on another
  /// Exact: yes. Cost: O(n + k log k) for n sides, k ends of them on the line.
  void keep(const MapLine& line, Sign kept, std::vector<MapSide>& sides);

 private:
  struct End {
    MapPoint at;
    int change;  // of whether a line just beside this one is within the part
  };
  MapPredicates& map_;
  std::vector<End> ends_;
};

}  // namespace hsr::internal
