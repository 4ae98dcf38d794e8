#pragma once

#include <optional>
#include <vector>

#include "hsr/lines/edge_classifier.h"
#include "hsr/lines/edge_parts.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/near_contact.h"
#include "hsr/scene/space_tree.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// Finds the classes of lines where all faces within a tolerance of a part count as touching it: a line that noise has moved off
/// a face by less has the class that it would have in it.
///
/// Not exact: distances and angles are doubles. The ends of parts are exact places on the edge all the same, such as where the
/// border of a face is seen to cross it. Cost: O(log n + k log k) for k triangles near the edge.
class NearParts {
 public:
  /// @pre tolerance > 0, and all that is given outlives this
  NearParts(const EdgeClassifier& classifier, const View& view, const SpaceTree& triangles, double tolerance)
      : classifier_(classifier),
        projected_(classifier.projected()),
        mesh_(projected_.mesh()),
        view_(view),
        triangles_(triangles),
        tolerance_(tolerance) {}

  /// As edge_parts().
  std::vector<EdgePart> of_edge(TriangleOcclusion& occlusion, EdgeId edge, std::vector<CoincidentFaces>* log) const;
  /// The class of a line in which two faces pierce each other, between these ends.
  PartClass of_intersection(const Point3& from, const Point3& to) const;

 private:
  struct Contact : NearContact {
    TriangleId triangle;
  };
  std::vector<Contact> contacts(const Point3& a, const Point3& b) const;
  std::optional<PartClass> class_at(const Point3& a, const Point3& b, double at, const std::vector<Contact>& near,
                                    bool only_diagonal, std::vector<CoincidentFaces>* log) const;
  void add_place(TriangleOcclusion& occlusion, EdgeId edge, TriangleId triangle, std::size_t side, double at, double length,
                 std::vector<Breakpoint>& places) const;

  const EdgeClassifier& classifier_;
  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const View& view_;
  const SpaceTree& triangles_;
  double tolerance_;
};

}  // namespace hsr::internal
