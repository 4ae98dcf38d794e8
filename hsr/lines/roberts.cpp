#include "hsr/lines/roberts.h"

#include "hsr/lines/hidden_intervals.h"

namespace hsr::internal {

VisibleLines roberts(const ProjectedMesh& projected, const ClassifiedEdges& requested, const Occluders& occluders,
                     const LineOptions& options, const OcclusionPyramid* pyramid, ShadowObserver* observer) {
  // Neighbours in the image meet the same triangles: in this order they are still in the cache.
  const std::vector<std::uint32_t> order = hilbert_order(requested.boxes);
  const auto add = [&](HiddenIntervals& intervals, std::uint32_t i) {
    if (!requested.hidden.empty() && requested.hidden[i] != 0)
      intervals.add_whole(requested[i], true);
    else
      intervals.add_by_casting(requested[i], requested.boxes[i], occluders, pyramid);
  };
  VisibleLines all = intervals_in_blocks(projected, options, order, add, observer);
  all.decisions += requested.decisions;
  return all;
}

VisibleLines lines_of_intersections(const ProjectedMesh& projected, const std::vector<Intersection>& segments,
                                    const std::vector<ImageBox>& boxes, const Occluders& occluders, const LineOptions& options,
                                    ShadowObserver* observer) {
  const auto add = [&](HiddenIntervals& intervals, std::uint32_t i) {
    intervals.add_by_casting(i, segments[i], boxes[i], occluders);
  };
  return intervals_in_blocks(projected, options, hilbert_order(boxes), add, observer);
}

}  // namespace hsr::internal
