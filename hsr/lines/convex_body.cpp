#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

#include "hsr/image_line.h"
#include "hsr/lines/bodies.h"
#include "hsr/lines/line_progress.h"
#include "hsr/lines/methods.h"
#include "hsr/lines/tiling.h"

namespace hsr {

VisibleLines lines_of_convex_body(const Sight& sight, const RequestedEdges& requested, const Bodies& bodies,
                                  const LineOptions& options) {
  const auto is_hidden = [&](EdgeId e) {
    const auto all = sight.mesh().triangles_at(e);
    return std::none_of(all.begin(), all.end(), [&](TriangleId t) { return bodies.is_on_near_side(t); });
  };
  LineProgress progress(options.progress, requested.edges.size());
  const std::size_t n = requested.edges.size();
  std::vector<VisibleLines> parts((n + edges_of_block - 1) / edges_of_block);
  std::vector<std::array<std::uint32_t, 2>> place(n);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Tiling tiling(sight, options);
      const std::size_t begin = part * edges_of_block, end = std::min(begin + edges_of_block, n);
      for (std::size_t i = begin; i < end; ++i) {
        place[i] = {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(i - begin)};
        const Edge& e = sight.mesh().edges[requested.edges[i]];
        if (ImageLine(sight, e.a, e.b).is_point(tiling.exact()))
          tiling.add_nothing(requested.edges[i], requested.classes[i]);
        else
          tiling.add_whole(requested.edges[i], requested.classes[i], is_hidden(requested.edges[i]));
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
