#pragma once

#include <cstdint>
#include <vector>

#include "geometry/box_tree.h"
#include "hsr/sight.h"

namespace hsr {

/// The triangles that can hide something, in a tree of their image boxes: not those wholly before the near plane, nor those
/// that are left out because they are hidden themselves.
/// Cost: O(n log n), parallel.
struct Occluders {
  std::vector<TriangleId> triangles;
  BoxTree tree;  ///< over `triangles`

  /// @param boxes of all triangles @param left_out by triangle; empty: none
  Occluders(const Sight& sight, const std::vector<ImageBox>& boxes, const std::vector<std::uint8_t>& left_out);
};

}  // namespace hsr
