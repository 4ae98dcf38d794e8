#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hsr/lines/edge_classifier.h"
#include "hsr/lines/edge_parts.h"
#include "hsr/lines/near_stretches.h"
#include "hsr/lines/triangle_occlusion.h"

namespace hsr::internal {

/// Finds the classes of lines where all faces within a tolerance of a part count as touching it: a line that noise has moved off
/// a face by less has the class that it would have in it.
///
/// Not exact: distances and angles are doubles. Cost: as NearStretches.
class NearParts {
 public:
  /// @pre all that is given outlives this
  NearParts(const EdgeClassifier& classifier, const View& view, const NearStretches& stretches)
      : classifier_(classifier), view_(view), stretches_(stretches) {}

  /// As edge_parts().
  std::vector<EdgePart> of_edge(TriangleOcclusion& occlusion, EdgeId edge, std::vector<CoincidentFaces>* log) const;
  /// The parts of a line in which two facets pierce each other: by more than noise, or else of the class of an edge.
  std::vector<EdgePart> of_intersection(TriangleOcclusion& occlusion, const Intersection& meet) const;

 private:
  PartClass of_intersection(const Intersection& meet, const Point3& a, const Point3& b, double at,
                            std::span<const TriangleId> touching) const;
  std::optional<PartClass> class_at(const Point3& a, const Point3& b, double at, std::span<const TriangleId> touching,
                                    bool only_diagonal, std::vector<CoincidentFaces>* log) const;

  const EdgeClassifier& classifier_;
  const View& view_;
  const NearStretches& stretches_;
};

}  // namespace hsr::internal
