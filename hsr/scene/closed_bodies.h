#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hsr/face_labels.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/star_shaped_bodies.h"

namespace hsr::internal {

/// The bodies of a scene that certainly hide their own far sides: those star-shaped ones that lie wholly on or beyond the near
/// plane. A line of sight that leaves one through a far side has entered it through a near side. With caps also bodies that a section cuts:
/// it has entered such a one through a near side or through a cap, where all that the section cuts of an object are bodies with one
/// orientation, whose outlines cannot cancel out.
///
///   (1) without the far sides nothing else is hidden or visible
///   (2) what lies between far sides only is hidden all along
///   (3) the same for any number of threads
///
/// Cost: O(n), parallel.
class ClosedBodies {
 public:
  ClosedBodies(const ProjectedMesh& projected, const StarShapedBodies& bodies);
  /// For methods that know what caps hide. @pre the view has a section
  static ClosedBodies with_caps(const ProjectedMesh& projected, const StarShapedBodies& bodies, const FaceLabels& labels);

  std::size_t count() const { return count_; }
  const std::vector<std::uint8_t>& far_sides() const { return far_sides_; }  ///< by triangle: 1, on the far side of a body
  bool is_on_near_side(TriangleId t) const { return projected_.facing(t) != Sign::zero && far_sides_[t.value] == 0; }
  /// Some triangle is at the edge, and all are on far sides.
  bool is_on_far_side(EdgeId e) const;
  /// All faces are those of one convex body, and there are no wires: an edge that is seen as a line is visible iff one of its
  /// faces is turned to the eye. Exact.
  bool is_one_convex_body() const { return is_one_convex_body_; }

 private:
  ClosedBodies(const ProjectedMesh& projected, const StarShapedBodies& bodies, const std::vector<std::uint8_t>& is_capped);

  const ProjectedMesh& projected_;
  std::size_t count_ = 0;
  bool is_one_convex_body_ = false;
  std::vector<std::uint8_t> far_sides_;
};

}  // namespace hsr::internal
