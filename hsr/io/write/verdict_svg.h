#pragma once

#include <string>
#include <vector>

#include "hsr/io/write/svg.h"
#include "hsr/painter/verify/verify.h"

namespace hsr::internal {

/// A picture of the violations of a verdict: the polygon that is painted earlier in blue, the later in red, a ring around each
/// witness. 180 mm wide or high.
std::string verdict_svg(const Verdict& verdict, const std::vector<PaintedPolygon>& far_to_near, const View& view,
                        const SvgOptions& options = {});

}  // namespace hsr::internal
