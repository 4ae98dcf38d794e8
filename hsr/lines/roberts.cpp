#include "hsr/lines/roberts.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "hsr/lines/line_progress.h"
#include "hsr/lines/methods.h"
#include "hsr/lines/occluders.h"
#include "hsr/lines/requested_edges.h"
#include "hsr/lines/tiling.h"
#include "hsr/sight.h"

namespace hsr {

VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options) {
  LineOptions by_roberts = options;
  by_roberts.method = LineMethod::roberts;
  return visible_lines(mesh, view, by_roberts);
}

VisibleLines roberts(const Sight& sight, const RequestedEdges& requested, const Occluders& occluders,
                     const LineOptions& options) {
  // Neighbours in the image meet the same triangles: in this order they are still in the cache.
  const std::vector<std::uint32_t> order = z_order(requested.boxes);
  std::vector<VisibleLines> parts((order.size() + edges_of_block - 1) / edges_of_block);
  std::vector<std::array<std::uint32_t, 2>> place(order.size());
  LineProgress progress(options.progress, order.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Tiling tiling(sight, options);
      const std::size_t begin = part * edges_of_block, end = std::min(begin + edges_of_block, order.size());
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t i = order[k];
        place[i] = {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k - begin)};
        if (!requested.hidden.empty() && requested.hidden[i] != 0)
          tiling.add_whole(requested.edges[i], requested.classes[i], true);
        else
          tiling.add_by_casting(requested.edges[i], requested.classes[i], requested.boxes[i], occluders);
      }
      parts[part] = tiling.take();
      progress.advance(end - begin);
    }
  });
  VisibleLines all = joined(parts, place);
  all.decisions += requested.decisions;
  return all;
}

}  // namespace hsr
