#include "hsr/scene/occluders.h"

#include <array>
#include <span>

#include "geometry/parallel.h"

namespace hsr::internal {

Occluders::Occluders(const ProjectedMesh& projected, const std::vector<std::uint8_t>& left_out) : projected_(&projected) {
  const std::size_t count = projected.mesh().triangles.size();
  triangles = parallel_collect<TriangleId>(count, [&](std::size_t begin, std::size_t end, std::vector<TriangleId>& part) {
    for (std::size_t i = begin; i < end; ++i)
      if (projected.reaches_beyond_near(TriangleId(i)) && (left_out.empty() || left_out[i] == 0)) part.emplace_back(i);
  });
  const auto boxes = std::make_unique_for_overwrite<ImageBox[]>(triangles.size());
  parallel_for_each(triangles.size(), [&](std::size_t i) { boxes[i] = projected.box(triangles[i]); });
  tree = BoxTree({boxes.get(), triangles.size()});
}

void Occluders::prepare() const {
  tbb::collaborative_call_once(filters_->flag, [&] {
    std::vector<TriangleId> order;
    order.reserve(triangles.size());
    filters_->place.resize(triangles.size());
    for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
      tree.visit_leaf<BoxTree::Depth::any>(leaf, ImageBox::everything(), [&](std::uint32_t i) {
        filters_->place[i] = static_cast<std::uint32_t>(order.size());
        order.push_back(triangles[i]);
        return true;
      });
    filters_->along_tree.resize(order.size());
    parallel_for_each(order.size(), [&](std::size_t k) { filters_->along_tree[k] = TriangleFilter(*projected_, order[k]); });
    filters_->is_made.store(true, std::memory_order_release);
  });
}

const std::vector<LeafCorners>& Occluders::leaf_corners() const {
  return leaf_corners_->get([&] {
    std::vector<LeafCorners> all(tree.leaf_count());
    parallel_for_each(all.size(), [&](std::size_t i) {
      const auto leaf = static_cast<std::uint32_t>(i);
      std::array<TriangleId, LeafCorners::width> in_leaf;
      const std::size_t n = tree.leaf_size(leaf);
      for (std::size_t k = 0; k < n; ++k) in_leaf[k] = triangles[tree.box_at(leaf, k)];
      all[i] = LeafCorners(*projected_, std::span(in_leaf).first(n));
    });
    return all;
  });
}

}  // namespace hsr::internal
