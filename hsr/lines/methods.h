#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/occluders.h"
#include "hsr/lines/requested_edges.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/sight.h"

// The methods over what they share, for visible_lines() to choose from.

namespace hsr {

class Layers;

VisibleLines roberts(const Sight& sight, const RequestedEdges& requested, const Occluders& occluders,
                     const LineOptions& options);
VisibleLines appel(const Sight& sight, const RequestedEdges& requested, const Layers& layers, const Occluders& occluders,
                   const LineOptions& options);
/// @pre the scene is one convex body, and requested.hidden says which edges have no face turned to the eye
VisibleLines lines_of_convex_body(const Sight& sight, const RequestedEdges& requested, const LineOptions& options);

}  // namespace hsr
