#pragma once

#include <array>
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
    visit(std::array{a, b}, distance, f);
  }
  /// The same for a triangle; it is among them.
  template <class F>
  void visit_near_triangle(const Mesh& mesh, TriangleId t, double distance, F&& f) const {
    const auto& c = mesh.triangles[t];
    visit(std::array{mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]}, distance, f);
  }

 private:
  template <class Points, class F>
  void visit(const Points& around, double distance, F&& f) const {
    ImageBox query = ImageBox::nothing();
    for (const Point3& p : around) query.add({p.x, p.y, p.z}, {distance, distance, distance});
    tree_.visit_touching(query, [&](std::uint32_t t) {
      f(TriangleId(t));
      return true;
    });
  }

  BoxTree tree_;  // x and y as in an image, z as nearness
};

}  // namespace hsr::internal
