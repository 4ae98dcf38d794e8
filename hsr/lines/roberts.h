#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"

namespace hsr {

/// The visible and the hidden parts of each edge: each edge against each face that overlaps it in the image.
///
///   (1) the intervals of one edge tile it beyond the near plane, and none is empty
///   (2) removing a face never removes a visible point
///   (3) the result does not depend on the order of the faces or on the number of threads
///
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k), k = edge-triangle pairs that overlap in the image.
/// Source: Roberts 1963, the hidden interval of each edge; closed triangles as bodies.
VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options = {});

}  // namespace hsr
