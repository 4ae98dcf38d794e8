#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"

namespace hsr {

/// The visible and the hidden parts of each edge, by quantitative invisibility: how many faces lie before a point of an edge
/// changes only where an occluding edge (an outline or a boundary) crosses before it, where the edge pierces a face, and at
/// vertices. It is counted once in each connected part of the drawing and carried on along the edges.
///
/// The same intervals and classes as `roberts`, for any mesh; cuts may be named otherwise where several coincide. Edges that
/// touch something in space, or cross the near plane, are done as `roberts` does them.
///
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k), k = pairs of an edge and an occluding edge that
/// overlap in the image: on closed meshes far fewer than the pairs of an edge and a face.
/// @throws PreconditionError if `options.why` is set: layers have no names; `roberts` gives them
/// Source: Appel 1967, "The notion of quantitative invisibility and the machine rendering of solids".
VisibleLines appel(const Mesh& mesh, const View& view, const LineOptions& options = {});

}  // namespace hsr
