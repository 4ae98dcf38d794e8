#pragma once

#include <oneapi/tbb/collaborative_call_once.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "hsr/scene/box_tree.h"
#include "hsr/scene/leaf_corners.h"
#include "hsr/scene/made_once.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/triangle_filter.h"

namespace hsr::internal {

/// The triangles that can hide something, in a tree of their image boxes: without those that the near plane cuts away wholly,
/// and without those that are left out because they are hidden themselves.
/// Cost: O(n log n), parallel.
class Occluders {
 public:
  std::vector<TriangleId> triangles;
  BoxTree tree;  ///< over `triangles`

  /// @param left_out by triangle; empty: none
  Occluders(const ProjectedMesh& projected, const std::vector<std::uint8_t>& left_out);

  /// Makes a filter of each of them, for who asks many questions about each. Once, whatever thread asks.
  /// Cost: O(n), parallel; then 200 bytes a triangle.
  void prepare() const;
  bool is_prepared() const { return filters_->is_made.load(std::memory_order_acquire); }
  /// The filters along the tree, so that near ones are near. @pre is_prepared()
  const std::vector<TriangleFilter>& faces() const { return filters_->along_tree; }
  /// Where the filter of each of `triangles` is among them. @pre is_prepared()
  const std::vector<std::uint32_t>& place() const { return filters_->place; }
  const TriangleFilter& face(std::uint32_t i) const { return filters_->along_tree[filters_->place[i]]; }
  /// The corners by leaf of the tree, for who asks the same of all triangles of a leaf. Made once, whatever thread asks first.
  /// Cost: O(n), parallel; then 40 bytes a triangle.
  const std::vector<LeafCorners>& leaf_corners() const;

 private:
  struct Filters {
    tbb::collaborative_once_flag flag;
    std::atomic<bool> is_made = false;
    std::vector<TriangleFilter> along_tree;
    std::vector<std::uint32_t> place;
  };

  const ProjectedMesh* projected_;
  std::unique_ptr<Filters> filters_ = std::make_unique<Filters>();
  std::unique_ptr<MadeOnce<std::vector<LeafCorners>>> leaf_corners_ = std::make_unique<MadeOnce<std::vector<LeafCorners>>>();
};

}  // namespace hsr::internal
