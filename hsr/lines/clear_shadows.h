#pragma once

#include <vector>

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/near_stretches.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/occluders.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// Finds what of a hidden part of an edge is hidden by more than noise: by something that does not touch it within a tolerance, or that
/// starts at it toward the eye, seen edge-on. The rest is hidden only by faces in which it lies but for the tolerance.
///
/// Exact: yes, for the triangles that touch it (NearStretches). One object per thread.
class ClearShadows {
 public:
  /// @param all triangles, without any that are left out as hidden @pre all that is given outlives this
  ClearShadows(const ProjectedMesh& projected, const View& view, const NearStretches& stretches, const Occluders& all)
      : projected_(projected), view_(view), stretches_(stretches), all_(all), occlusion_(projected) {}

  /// Turns to a part of an edge. @pre something of it is beyond the near plane, and it is not seen as a point
  void turn_to(const RequestedPart& part);

  /// A hidden interval of the part, cut where a clear shadow begins or ends: its pieces are in one and in none, in turn.
  struct Divided {
    bool starts_clear = false;
    std::vector<Cut> cuts;  ///< the ends of the interval among them
  };
  Divided divided(const Cut& from, const Cut& to);

 private:
  void cast_on(const RequestedPart& part, const NearStretch& stretch);
  bool hides_by_noise(EdgeId edge, const NearStretch& stretch, TriangleId touching) const;
  Breakpoint place(const Cut& cut);

  const ProjectedMesh& projected_;
  const View& view_;
  const NearStretches& stretches_;
  const Occluders& all_;
  TriangleOcclusion occlusion_;
  std::vector<HiddenInterval> shadows_;  // clear ones, ascending and apart
};

}  // namespace hsr::internal
