#pragma once

#include <cstddef>

#include "geometry/mesh.h"

namespace hsr::internal {

/// Signs that coordinates were rounded after the model was made: drawn exactly, such noise shows.
struct InputNoise {
  std::size_t open_edges = 0;   ///< edges of one face that would have two
  std::size_t near_planes = 0;  ///< faces that touch another, nearly in one plane with it, but not exactly
  double tolerance = 0;         ///< with which both are mended; 0: there are no such signs
};

/// Looks for noise of a few units in the last place of the largest coordinate (of floats, if all coordinates are floats), or in the
/// last of five to nine decimals, or of six or seven significant digits.
///
/// Not exact, it only proposes: distances are doubles. Faces in a mesh of more than 200 000 triangles are not looked at for near
/// planes. Cost: O(n log n) in edges of one face, and in triangles.
InputNoise noise_of(const Mesh& mesh);

}  // namespace hsr::internal
