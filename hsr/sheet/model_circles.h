#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::internal {

/// A circle, or most of one, that sharp edges and borders of a model lie on. A choice of what is drawn, in doubles.
struct ModelCircle {
  Point3 centre;
  Point3 axis;  ///< of length 1, either way
  double radius = 0;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< i < j, ascending
};

/// The circles of a model: runs of edges of one face, or between faces that deviate from flat by more than `crease` degrees, that
/// go around one axis by at least 170 degrees, each by at most 46, with the same curvature all along.
///
/// Cost: O(n log n) in edges.
std::vector<ModelCircle> model_circles(const Mesh& mesh, double crease);

/// Circles with one axis, and where along it, from the axis's point on, their centres are.
struct ModelAxis {
  Point3 point, direction;
  double first = 0, last = 0;
  double radius = 0;  ///< the largest
};

/// The axes of circles. @param reach what is less than a ten-thousandth of it apart is at one place
std::vector<ModelAxis> axes_of(const std::vector<ModelCircle>& circles, double reach);

}  // namespace hsr::internal
