#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::internal {

/// What is left of a mesh before a method draws it.
struct Culled {
  std::vector<TriangleId> kept;  ///< ascending
  std::uint64_t culled = 0;      ///< triangles
  std::uint64_t tests = 0;       ///< of triangles, or of what bounds some of them
};

}  // namespace hsr::internal
