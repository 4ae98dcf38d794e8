#include "hsr/lines/convex_body.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "hsr/lines/hidden_intervals.h"
#include "hsr/scene/line_filter.h"

namespace hsr::internal {

VisibleLines lines_of_convex_body(const ProjectedMesh& projected, const ClassifiedEdges& requested, const ClosedBodies& bodies,
                                  const LineOptions& options) {
  const auto is_hidden = [&](EdgeId e) {
    const auto all = projected.mesh().triangles_at(e);
    return std::none_of(all.begin(), all.end(), [&](TriangleId t) { return bodies.is_on_near_side(t); });
  };
  std::vector<std::uint32_t> order(requested.edges.size());
  std::iota(order.begin(), order.end(), 0U);
  VisibleLines all = intervals_in_blocks(projected, options, order, [&](HiddenIntervals& intervals, std::uint32_t i) {
    const EdgeId id = requested.edges[i];
    const Edge& e = projected.mesh().edges[id];
    if (LineFilter(projected, e.a, e.b).is_point(intervals.exact()))
      intervals.add_nothing(requested[i]);
    else
      intervals.add_whole(requested[i], is_hidden(id));
  });
  all.decisions += requested.decisions;
  return all;
}

}  // namespace hsr::internal
