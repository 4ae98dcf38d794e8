#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

namespace hsr::internal {

/// The part of a segment that is within a tolerance of a triangle, in parameters from 0 to 1. Where it does not go on to the end of
/// the segment it ends at one of the triangle's sides, counted from corner k to the next.
struct NearContact {
  double from = 0, to = 1;
  std::size_t side_from = 3, side_to = 3;
  double rise_from = 0, rise_to = 0;  ///< how much nearer the one end of the segment is to the line of that side than the other
};

/// Nothing: there is no such part that is longer than twice the tolerance. Not exact: distances are doubles.
std::optional<NearContact> near_contact(const Mesh& mesh, TriangleId triangle, const Point3& a, const Point3& b,
                                        double tolerance);

}  // namespace hsr::internal
