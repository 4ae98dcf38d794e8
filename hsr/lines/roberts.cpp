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

VisibleLines roberts(const ProjectedMesh& projected, const ClassifiedEdges& requested, const Occluders& occluders,
                     const LineOptions& options, const OcclusionPyramid* pyramid) {
  // Neighbours in the image meet the same triangles: in this order they are still in the cache.
  const std::vector<std::uint32_t> order = hilbert_order(requested.boxes);
  VisibleLines all = intervals_in_blocks(projected, options, order, [&](HiddenIntervals& intervals, std::uint32_t i) {
    if (!requested.hidden.empty() && requested.hidden[i] != 0)
      intervals.add_whole(requested[i], true);
    else
      intervals.add_by_casting(requested[i], requested.boxes[i], occluders, pyramid);
  });
  all.decisions += requested.decisions;
  return all;
}

VisibleLines lines_of_intersections(const ProjectedMesh& projected, const std::vector<Intersection>& united,
                                    const std::vector<ImageBox>& boxes, const Occluders& occluders,
                                    const LineOptions& options) {
  return intervals_in_blocks(projected, options, hilbert_order(boxes), [&](HiddenIntervals& intervals, std::uint32_t i) {
    intervals.add_by_casting(i, united[i], boxes[i], occluders);
  });
}

}  // namespace hsr
