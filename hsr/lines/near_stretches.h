#pragma once

#include <vector>

#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/near_contact.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/space_tree.h"

namespace hsr::internal {

/// A part of an edge, and the triangles that touch all of it but for a tolerance, ascending.
struct NearStretch {
  Breakpoint from, to;
  std::vector<TriangleId> touching;
};

/// Finds which triangles are within a tolerance of a part of a line, and count as touching it.
///
/// Distances are doubles. The ends of stretches are exact places on the edge all the same: where the border of a face is seen to
/// cross it. Cost: O(log n + k log k) for k triangles near the edge.
class NearStretches {
 public:
  /// @pre tolerance > 0, and all that is given outlives this
  NearStretches(const ProjectedMesh& projected, const SpaceTree& triangles, double tolerance)
      : projected_(projected), mesh_(projected.mesh()), triangles_(triangles), tolerance_(tolerance) {}

  double tolerance() const { return tolerance_; }

  /// They tile what of a line is beyond the near plane. None but a single one is shorter than twice the tolerance, or so.
  /// @param occlusion was turned to the line @param a, b its ends, an intersection's rounded
  std::vector<NearStretch> of_line(TriangleOcclusion& occlusion, const Point3& a, const Point3& b) const;
  std::vector<NearStretch> of_edge(TriangleOcclusion& occlusion, EdgeId id) const {
    const Edge& edge = mesh_.edges[id];
    return of_line(occlusion, mesh_.points[edge.a], mesh_.points[edge.b]);
  }

 private:
  struct Contact : NearContact {
    TriangleId triangle;
  };
  std::vector<Contact> contacts(const Point3& a, const Point3& b) const;

  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const SpaceTree& triangles_;
  double tolerance_;
};

}  // namespace hsr::internal
