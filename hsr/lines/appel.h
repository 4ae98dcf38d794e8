#pragma once

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"

namespace hsr::internal {

class CountObserver;

/// The visible and the hidden parts of each edge, by quantitative invisibility: the number of faces in front of a point of an
/// edge changes only where an occluding edge (an outline or a boundary) crosses in front of it, where the edge pierces a face,
/// and at vertices. It is counted once in each connected part of the drawing and carried on along the edges.
///
/// It gives the intervals and classes of `roberts` for any mesh; where several cuts coincide, another one may name the end.
/// Edges that touch something in space, or cross the near plane, are done as `roberts` does them.
///
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k), k = pairs of an edge and an occluding edge that
/// overlap in the image: on closed meshes far fewer than the pairs of an edge and a face.
/// @pre `options.why` is not set: layers have no names; `roberts` gives them
/// @param observer is told how, in one thread; null: nobody is
/// Source: Appel 1967, "The notion of quantitative invisibility and the machine rendering of solids".
VisibleLines appel(const ProjectedMesh& projected, const ClassifiedEdges& requested, const OccludingEdges& layers,
                   const Occluders& occluders, const LineOptions& options, CountObserver* observer = nullptr);

}  // namespace hsr::internal
