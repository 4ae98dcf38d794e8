#pragma once

#include "geometry/point.h"

namespace hsr {

/// A point of a result in numbers. Each is the double nearest to the exact coordinate, ties to even, and never -0; beyond the
/// largest double, an infinity.
struct PlacedPoint {
  Point3 space;  ///< in the coordinates of the mesh
  Point2 paper;  ///< in the view's frame: x to the right, y up, in units of the frame

  friend bool operator==(const PlacedPoint&, const PlacedPoint&) = default;
};

}  // namespace hsr
