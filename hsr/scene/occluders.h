#pragma once

#include <cstdint>
#include <vector>

#include "hsr/scene/box_tree.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/triangle_filter.h"

namespace hsr {

/// The triangles that can hide something, in a tree of their image boxes: without those that the near plane cuts away wholly,
/// and without those that are left out because they are hidden themselves.
/// Cost: O(n log n), parallel.
struct Occluders {
  std::vector<TriangleId> triangles;
  BoxTree tree;                       ///< over `triangles`
  std::vector<TriangleFilter> faces;  ///< in the order of the leaves of the tree; empty unless prepared
  std::vector<std::uint32_t> place;   ///< triangles[i] has the filter faces[place[i]]

  /// @param boxes of all triangles @param left_out by triangle; empty: none
  Occluders(const ProjectedMesh& projected, const std::vector<ImageBox>& boxes, const std::vector<std::uint8_t>& left_out);
  /// For many questions about each of them. Cost: O(n), parallel.
  void prepare(const ProjectedMesh& projected);
  const TriangleFilter& face(std::uint32_t i) const { return faces[place[i]]; }
};

}  // namespace hsr
