#include "hsr/drawing/marked_circles.h"

#include <algorithm>
#include <tuple>

namespace hsr::internal {

MarkedCircles::MarkedCircles(const Mesh& mesh, const FaceLabels& labels) {
  for (const MarkedEdge& mark : labels.marks) {
    if (mark.circle >= labels.circles.size()) continue;
    const auto [a, b] = std::minmax(mesh.merged[VertexId(mark.points[0])], mesh.merged[VertexId(mark.points[1])]);
    if (a != b) rows_.push_back({a, b, &labels.circles[mark.circle]});
  }
  const auto ends = [](const Row& r) { return std::tuple(r.a, r.b); };
  std::ranges::stable_sort(rows_, {}, ends);
  rows_.erase(std::unique(rows_.begin(), rows_.end(), [&](const Row& x, const Row& y) { return ends(x) == ends(y); }),
              rows_.end());
}

const KnownCircle* MarkedCircles::of(VertexId a, VertexId b) const {
  if (b < a) std::swap(a, b);
  const auto row = std::ranges::lower_bound(rows_, std::tuple(a, b), {}, [](const Row& r) { return std::tuple(r.a, r.b); });
  return row != rows_.end() && row->a == a && row->b == b ? row->circle : nullptr;
}

}  // namespace hsr::internal
