#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/painter/painters_order.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A picture by the scanline algorithm, and what it took.
struct Scanline {
  Image<TriangleId> triangles;          ///< not valid: none. Of a piece: the first of its facet
  std::uint64_t spans = 0;              ///< between neighbouring edges of a row
  std::uint64_t depth_comparisons = 0;  ///< of two faces, where a span begins
  std::size_t most_active = 0;          ///< edges that one row crosses
  std::size_t bytes = 0;                ///< working storage beside the picture: edge table, face table, active edges
};

/// The scanline algorithm for visible surfaces: row by row, active edges from the left, and a flag for each face that tells
/// whether the row is inside it. Faces are compared only where a span begins: a face that begins, with the one shown before;
/// where the one shown ends, those that are inside. From there to the next edge nothing is asked.
///
/// That rests on faces that do not pierce each other. Where they do, a span keeps the face that it began with: the picture is
/// wrong, which is what this form is for.
///
///   (1) where no two triangles pierce or coincide, the depths of z_buffer<double>(), but for rounding
///
/// Exact: no. Degenerate: samples on edges as z_buffer() has them; of two faces that a row shows as one line, the
/// one on top. Cost: O(n log n + crossings of edges and rows + samples); one thread.
/// Source: Wylie, Romney, Evans & Erdahl 1967; Bouknight 1970; Foley, van Dam, Feiner & Hughes 1990, "scan-line algorithms".
Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties = {});

/// The scanline algorithm on the pieces of a painter's order, which do not pierce each other since the depth sort has cut them
/// (hsr/painter/sort/depth_sort.h). The cuts of cyclic overlaps are not needed here, and do no harm.
///
///   (2) the picture of the nearest faces, but for edges that rounding moves and depths that it ties
Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, const PaintersOrder& pieces,
                  TieRule ties = {});

}  // namespace hsr::internal
