#include "hsr/scene/space_tree.h"

#include "geometry/parallel.h"

namespace hsr::internal {

SpaceTree::SpaceTree(const Mesh& mesh, double margin) {
  std::vector<ImageBox> boxes(mesh.triangles.size(), ImageBox::nothing());
  parallel_for_each(boxes.size(), [&](std::size_t t) {
    for (const VertexId v : mesh.triangles[TriangleId(t)]) {
      const Point3& p = mesh.points[v];
      boxes[t].add({p.x, p.y, p.z}, {margin, margin, margin});
    }
  });
  tree_ = BoxTree(boxes);
}

}  // namespace hsr::internal
