#pragma once

#include <string>
#include <vector>

#include "hsr/lines/line_options.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// What visible lines take, and what they do without.
struct LinePlan {
  std::string method;  ///< "appel" or "roberts"; "none" for one convex body
  std::vector<LeftOut> left_out;
};

/// What visible_lines() would do, without doing it. Cost: O(n log n + k) for k pairs of faces that nearly touch, parallel.
LinePlan plan_lines(const SceneView& scene, const LineOptions& options = {});

}  // namespace hsr
