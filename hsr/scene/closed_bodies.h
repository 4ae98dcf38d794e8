#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The bodies of a scene that certainly hide their own far sides.
///
/// A body is a component of faces, connected by edges of just two triangles, that is closed and consistently oriented, lies
/// wholly on or beyond the near plane, and is star-shaped: some point inside sees all of it. So it meets itself nowhere, and a
/// line of sight that leaves it through a far side has entered it through a near side. Which way its faces are turned does not
/// matter. A component for which error bounds do not prove all this is no body.
///
///   (1) without the far sides nothing else is hidden or visible
///   (2) what lies between far sides only is hidden all along
///   (3) the same for any number of threads
///
/// Cost: O(n), parallel.
/// Source: Mehlhorn, Näher, Seel et al. 1999, "Checking geometric programs or verification of geometric structures": one ray
/// from inside that meets one face tells that a surface that turns everywhere the same way goes around once.
class ClosedBodies {
 public:
  explicit ClosedBodies(const ProjectedMesh& projected);

  std::size_t count() const { return count_; }
  const std::vector<std::uint8_t>& far_sides() const { return far_sides_; }  ///< by triangle: 1, on the far side of a body
  bool is_on_near_side(TriangleId t) const { return projected_.facing(t) != Sign::zero && far_sides_[t.value] == 0; }
  /// Some triangle is at the edge, and all are on far sides.
  bool is_on_far_side(EdgeId e) const;
  /// All faces are those of one convex body, and there are no wires: an edge that is seen as a line is visible iff one of its
  /// faces is turned to the eye. Exact.
  bool is_one_convex_body() const;

 private:
  const ProjectedMesh& projected_;
  std::size_t count_ = 0;
  bool is_alone_ = false;     // the first body, with all triangles
  Sign inside_ = Sign::zero;  // of the first body: on which side of its faces it lies
  std::vector<std::uint8_t> far_sides_;
};

}  // namespace hsr::internal
