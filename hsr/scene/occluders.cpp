#include "hsr/scene/occluders.h"

#include "geometry/parallel.h"

namespace hsr {

Occluders::Occluders(const ProjectedMesh& projected, const std::vector<ImageBox>& boxes,
                     const std::vector<std::uint8_t>& left_out) {
  triangles =
      parallel_collect<TriangleId>(boxes.size(), [&](std::size_t begin, std::size_t end, std::vector<TriangleId>& part) {
        for (std::size_t i = begin; i < end; ++i)
          if (projected.reaches_beyond_near(TriangleId(i)) && (left_out.empty() || left_out[i] == 0)) part.emplace_back(i);
      });
  if (triangles.size() == boxes.size()) {
    tree = BoxTree(boxes);
    return;
  }
  std::vector<ImageBox> kept(triangles.size());
  parallel_for_each(kept.size(), [&](std::size_t i) { kept[i] = boxes[triangles[i].value]; });
  tree = BoxTree(kept);
}

void Occluders::prepare(const ProjectedMesh& projected) {
  if (!faces.empty()) return;
  std::vector<TriangleId> along_tree;
  along_tree.reserve(triangles.size());
  place.resize(triangles.size());
  for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
    tree.visit_leaf<BoxTree::Depth::any>(leaf, ImageBox::everything(), [&](std::uint32_t i) {
      place[i] = static_cast<std::uint32_t>(along_tree.size());
      along_tree.push_back(triangles[i]);
      return true;
    });
  faces.resize(along_tree.size());
  parallel_for_each(faces.size(), [&](std::size_t k) { faces[k] = TriangleFilter(projected, along_tree[k]); });
}

}  // namespace hsr
