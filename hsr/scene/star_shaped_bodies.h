#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hsr/scene/scaled_mesh.h"

namespace hsr::internal {

/// The components of faces that certainly bound a star-shaped body: what no view changes of ClosedBodies.
///
/// A component is connected by edges of just two triangles. It bounds a body if it is closed and consistently oriented, and some
/// point inside sees all of it; so it meets itself nowhere. Which way its faces are turned does not matter. A component for which
/// error bounds do not prove all this is no body. The same for any number of threads.
///
/// Cost: O(n), parallel.
/// Source: Mehlhorn, Näher, Seel et al. 1999, "Checking geometric programs or verification of geometric structures": one ray
/// from inside that meets one face tells that a surface that turns everywhere the same way goes around once.
class StarShapedBodies {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  explicit StarShapedBodies(const ScaledMesh& scaled);

  std::size_t count() const { return inside_.size(); }
  /// The body that a triangle bounds; none: it bounds none.
  std::uint32_t body_of(TriangleId t) const { return body_of_[t.value]; }
  /// On which side of its triangles' planes a body lies.
  Sign inside(std::uint32_t body) const { return inside_[body]; }
  /// All faces are those of one convex body, and there are no wires. Exact.
  bool is_one_convex_body() const { return is_one_convex_body_; }

 private:
  std::vector<std::uint32_t> body_of_;
  std::vector<Sign> inside_;
  bool is_one_convex_body_ = false;
};

}  // namespace hsr::internal
