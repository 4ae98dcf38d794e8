#pragma once

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::internal {

/// Parts of edges that have another class where they are hidden become several lines, one for each interval, in the class that
/// they have there; of classes that are not asked for there are none.
/// @param lines the first of them those of the edges
VisibleLines with_hidden_classes(const Mesh& mesh, const View& view, const ClassifiedEdges& edges, const LineOptions& options,
                                 VisibleLines lines);

}  // namespace hsr::internal
