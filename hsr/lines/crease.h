#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/mesh.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The angle by which the two faces of a sharp edge deviate from flat. It is measured in doubles, so an edge whose faces meet at
/// just this angle would be sharp or smooth by the noise of its coordinates: more means by over a hundredth of a degree.
struct Crease {
  double degrees;          ///< what is more than this is sharp
  double goes_on_degrees;  ///< what is more than this is sharp where it leads to something sharp; at most `degrees`
  double cosine, goes_on_cosine;

  Crease(double asked, double goes_on)
      : degrees(asked + 0.01),
        goes_on_degrees(std::min(asked, goes_on) + 0.01),
        cosine(std::cos(degrees * std::numbers::pi / 180)),
        goes_on_cosine(std::cos(goes_on_degrees * std::numbers::pi / 180)) {}
};

/// By how many degrees two half-planes at an edge, each given by a vertex in it, deviate from one plane: 0 ... 180.
/// @pre neither vertex is on the line of the edge. Exact: to nine digits.
double deviation_from_flat(const ProjectedMesh& projected, const Edge& edge, VertexId in_one, VertexId in_other);

}  // namespace hsr::internal
