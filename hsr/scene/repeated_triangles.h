#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace hsr::internal {

/// Triangles that a file stores several times: the same corners, and the same sides that are edges of the mesh. What others have in
/// common with one they have in common with each, so that a search asks once.
///
/// Cost: O(n), and O(m log m) for m triangles at an edge of several that look alike.
class RepeatedTriangles {
 public:
  explicit RepeatedTriangles(const Mesh& mesh);

  bool empty() const { return first_.empty(); }
  /// The first that equals it: mostly itself.
  TriangleId first(TriangleId t) const { return first_.empty() ? t : first_[t.value]; }

 private:
  std::vector<TriangleId> first_;  // by triangle; empty: none is repeated
};

}  // namespace hsr::internal
