#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// The triangles of a mesh in a tree of their boxes in space: no view changes it.
class SpaceTree {
 public:
  /// @param margin by which each box is larger on every side
  explicit SpaceTree(const Mesh& mesh, double margin = 0);

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

  /// Calls make()(s, t) for every two triangles whose boxes touch, each pair once, in parallel: make() for each block of them.
  template <class F>
  void visit_pairs(const F& make) const {
    constexpr std::size_t block = 64;  // leaves
    const std::size_t leaves = tree_.leaf_count();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (leaves + block - 1) / block, 1), [&](const auto& range) {
      for (std::size_t part = range.begin(); part < range.end(); ++part) {
        auto visit = make();
        BoxTree::PairSearch search;
        for (std::size_t leaf = part * block; leaf < std::min(leaves, (part + 1) * block); ++leaf)
          tree_.visit_pairs(static_cast<std::uint32_t>(leaf), search,
                            [&](std::uint32_t s, std::uint32_t t) { visit(TriangleId(s), TriangleId(t)); });
      }
    });
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
