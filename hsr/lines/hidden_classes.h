#pragma once

#include <optional>
#include <vector>

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/near_stretches.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// With a tolerance: which triangles touch an edge, and all triangles, without any that are left out as hidden.
struct NearOccluders {
  const NearStretches& stretches;
  const Occluders& all;
};

/// What of a line depends on whether it is hidden there.
struct ByVisibility {
  std::optional<EdgeClass> hidden = {};       ///< its class where it is hidden, if that is another
  std::optional<EdgeClass> behind_seen = {};  ///< of what is behind it where it is visible, if that is more than elsewhere
};

/// By line. Empty: nothing of any does.
using ClassesByVisibility = std::vector<ByVisibility>;

/// Lines that have another class where they are hidden become several, one for each interval, in the class that they have there; of
/// classes that are not asked for there are none. What of an edge is hidden only by noise has the class of what is seen, and behind
/// it what is behind that.
/// @param lines the first of them those of `edges` @param near nullptr: without a tolerance
VisibleLines with_hidden_classes(const ProjectedMesh& projected, const View& view, const ClassifiedEdges& edges,
                                 const LineOptions& options, const NearOccluders* near, const ClassesByVisibility& classes,
                                 VisibleLines lines);

}  // namespace hsr::internal
