#pragma once

#include <string>

#include "hsr/drawing/painting.h"
#include "hsr/io/write/svg.h"

namespace hsr::internal {

/// A painting order as SVG: every piece in turn, its lines on top of it, so that later pieces cover both.
///
/// No seam shows between opaque pieces: what is painted is underlaid with pens of the pieces' own colours, as fills are. Where
/// some are transparent that would show: the opaque ones have a fine pen instead, which closes most of a seam.
std::string painting_svg(const Painting& painting, double opacity, const SvgOptions& options = {});

}  // namespace hsr::internal
