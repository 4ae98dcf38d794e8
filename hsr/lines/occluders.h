#pragma once

#include <vector>

#include "geometry/box_tree.h"
#include "hsr/sight.h"

namespace hsr {

/// The triangles that can hide something, in a tree of their image boxes: not those wholly before the near plane.
/// Cost: O(n log n), parallel.
struct Occluders {
  std::vector<TriangleId> triangles;
  BoxTree tree;  ///< over `triangles`

  explicit Occluders(const Sight& sight);
};

}  // namespace hsr
