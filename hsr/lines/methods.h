#pragma once

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"

// The methods over what they share, for visible_lines() to choose from.

namespace hsr {

class ClosedBodies;
class OcclusionPyramid;
class OccludingEdges;

/// @param pyramid what is known to be hidden, or nullptr
VisibleLines roberts(const ProjectedMesh& projected, const ClassifiedEdges& requested, const Occluders& occluders,
                     const LineOptions& options, const OcclusionPyramid* pyramid = nullptr);
VisibleLines appel(const ProjectedMesh& projected, const ClassifiedEdges& requested, const OccludingEdges& layers,
                   const Occluders& occluders, const LineOptions& options);
/// @pre bodies.is_one_convex_body()
VisibleLines lines_of_convex_body(const ProjectedMesh& projected, const ClassifiedEdges& requested, const ClosedBodies& bodies,
                                  const LineOptions& options);

/// The visible and the hidden parts of where faces pierce each other, numbered as in `merge_segments` (contacts/intersections.h).
VisibleLines lines_of_intersections(const ProjectedMesh& projected, const std::vector<Intersection>& united,
                                    const std::vector<ImageBox>& boxes, const Occluders& occluders, const LineOptions& options);

}  // namespace hsr
