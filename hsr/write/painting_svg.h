#pragma once

#include <string>

#include "hsr/drawing/painting.h"
#include "hsr/write/svg.h"

namespace hsr {

/// A painting order as SVG: every piece in turn, its lines on top of it, so that later pieces cover both. A pen of the piece's
/// own colour closes the seams between neighbours, where it is opaque.
std::string painting_svg(const Painting& painting, double opacity, const SvgOptions& options = {});

}  // namespace hsr
