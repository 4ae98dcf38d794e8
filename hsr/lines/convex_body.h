#pragma once

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/closed_bodies.h"

namespace hsr::internal {

/// The lines of a scene that is one convex body: an edge is visible iff one of its faces is turned to the eye.
/// @pre bodies.is_one_convex_body()
VisibleLines lines_of_convex_body(const ProjectedMesh& projected, const ClassifiedEdges& requested, const ClosedBodies& bodies,
                                  const LineOptions& options);

}  // namespace hsr::internal
