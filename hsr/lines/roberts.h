#pragma once

#include <vector>

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occlusion_pyramid.h"

namespace hsr::internal {

class ShadowObserver;

/// The visible and the hidden parts of each edge: each edge against each face that overlaps it in the image.
///
///   (1) the intervals of one edge tile it beyond the near plane, and none is empty
///   (2) removing a face never removes a visible point
///   (3) the result does not depend on the order of the faces or on the number of threads
///
/// @param pyramid null: nothing is known to be hidden @param observer is told how; null: nobody is
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k), k = edge-triangle pairs that overlap in the image.
/// Source: Roberts 1963, the hidden interval of each edge; closed triangles as bodies.
VisibleLines roberts(const ProjectedMesh& projected, const ClassifiedEdges& requested, const Occluders& occluders,
                     const LineOptions& options, const OcclusionPyramid* pyramid = nullptr, ShadowObserver* observer = nullptr);

/// The visible and the hidden parts of where faces pierce each other, numbered as in `segments`, which merge_segments() gave.
/// @param boxes of the segments in the image
VisibleLines lines_of_intersections(const ProjectedMesh& projected, const std::vector<Intersection>& segments,
                                    const std::vector<ImageBox>& boxes, const Occluders& occluders, const LineOptions& options,
                                    ShadowObserver* observer = nullptr);

}  // namespace hsr::internal
