#include "hsr/drawing/end_images.h"

#include "geometry/parallel.h"

namespace hsr::internal {

EndImages::EndImages(const Projection& projection, const VisibleLines& lines, std::span<const std::uint32_t> drawn) {
  constexpr std::uint32_t none = 0xffffffffU;
  const Mesh& mesh = projection.mesh();
  place_.resize(mesh.points.size(), none);
  std::vector<VertexId> ends;
  for (const std::uint32_t i : drawn) {
    if (lines.lines[i].is_intersection()) continue;
    const Edge& e = mesh.edges[lines.lines[i].edge];
    for (const VertexId v : {e.a, e.b}) {
      if (place_[v.value] != none) continue;
      place_[v.value] = static_cast<std::uint32_t>(ends.size());
      ends.push_back(v);
    }
  }
  at_.resize(ends.size());
  parallel_for_each(ends.size(), [&](std::size_t k) { at_[k] = projection.at(ends[k]); });
}

}  // namespace hsr::internal
