#pragma once

#include "geometry/flat_orientation.h"
#include "geometry/index.h"

namespace hsr::internal {

/// The plane of the coordinates that are left when one is dropped, turned so that the polygon in hand runs counter-clockwise.
struct FlatPlane {
  const IndexedVector<VertexId, Point3>& points;
  Predicates& predicates;
  int axis = 2;
  Sign turn = Sign::positive;  ///< negative: the polygon's normal has a negative component along the axis

  Sign orientation(VertexId a, VertexId b, VertexId c) const {
    return turn * normal_sign(points[a], points[b], points[c], axis, predicates);
  }
};

}  // namespace hsr::internal
