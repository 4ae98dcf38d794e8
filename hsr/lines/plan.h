#pragma once

#include <vector>

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// What visible_lines() would do, without doing it. Cost: O(n log n + k) for k pairs of faces that nearly touch, parallel.
LinePlan plan_lines(const SceneView& scene, const LineOptions& options = {});

/// visible_lines(), and the edges of which only faces elsewhere tell what they are: see TouchingRegions. @pre the view has no cells
VisibleLines visible_lines_and_doubts(const SceneView& scene, const LineOptions& options, std::vector<EdgeId>& in_doubt);

}  // namespace hsr::internal
