#include "hsr/lines/roberts.h"

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/hidden_intervals.h"
#include "hsr/lines/methods.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr {

VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options) {
  LineOptions by_roberts = options;
  by_roberts.method = LineMethod::roberts;
  return visible_lines(mesh, view, by_roberts);
}

VisibleLines roberts(const Sight& sight, const RequestedEdges& requested, const Occluders& occluders,
                     const LineOptions& options, const HiddenTiles* tiles) {
  // Neighbours in the image meet the same triangles: in this order they are still in the cache.
  const std::vector<std::uint32_t> order = hilbert_order(requested.boxes);
  VisibleLines all = tiled_in_blocks(sight, options, order, [&](Tiling& tiling, std::uint32_t i) {
    if (!requested.hidden.empty() && requested.hidden[i] != 0)
      tiling.add_whole(requested[i], true);
    else
      tiling.add_by_casting(requested[i], requested.boxes[i], occluders, tiles);
  });
  all.decisions += requested.decisions;
  return all;
}

VisibleLines lines_of_intersections(const Sight& sight, const std::vector<Intersection>& united,
                                    const std::vector<ImageBox>& boxes, const Occluders& occluders,
                                    const LineOptions& options) {
  return tiled_in_blocks(sight, options, hilbert_order(boxes),
                         [&](Tiling& tiling, std::uint32_t i) { tiling.add_by_casting(i, united[i], boxes[i], occluders); });
}

}  // namespace hsr
