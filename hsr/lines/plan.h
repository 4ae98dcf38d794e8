#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// What visible_lines() would do, without doing it. Cost: O(n log n + k) for k pairs of faces that nearly touch, parallel.
LinePlan plan_lines(const SceneView& scene, const LineOptions& options = {});

}  // namespace hsr::internal
