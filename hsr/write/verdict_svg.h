#pragma once

#include <string>
#include <vector>

#include "hsr/painter/verify.h"
#include "hsr/write/svg.h"

namespace hsr {

/// A picture of the violations of a verdict: the polygon that is painted earlier in blue, the later in red, a ring around each
/// witness. 180 mm wide or high.
std::string verdict_svg(const Verdict& verdict, const std::vector<PaintedPolygon>& far_to_near, const View& view,
                        const SvgOptions& options = {});

}  // namespace hsr
