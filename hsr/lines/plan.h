#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/lines/line_options.h"
#include "hsr/view/view.h"

namespace hsr {

/// A stage that a result does without, and why; or what a stage saved.
struct LeftOut {
  std::string stage, why;
};

/// What visible lines take, and what they do without.
struct LinePlan {
  std::string method;  ///< "appel" or "roberts"; "none" for one convex body
  std::vector<LeftOut> left_out;
};

/// What visible_lines() would do, without doing it. Cost: O(n log n + k) for k pairs of faces that nearly touch, parallel.
LinePlan plan_lines(const Mesh& mesh, const View& view, const LineOptions& options = {});

}  // namespace hsr
