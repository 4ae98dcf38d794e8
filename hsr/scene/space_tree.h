#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// The triangles of a mesh in a tree of their boxes in space: no view changes it.
class SpaceTree {
 public:
  explicit SpaceTree(const Mesh& mesh);

  /// Calls f(triangle) for all that may be within a distance of the segment from a to b, and for some more.
  template <class F>
  void visit_near(const Point3& a, const Point3& b, double distance, F&& f) const {
    ImageBox query = ImageBox::nothing();
    for (const Point3* p : {&a, &b}) query.add({p->x, p->y, p->z}, {distance, distance, distance});
    tree_.visit_touching(query, [&](std::uint32_t t) {
      f(TriangleId(t));
      return true;
    });
  }

 private:
  BoxTree tree_;  // x and y as in an image, z as nearness
};

}  // namespace hsr::internal
