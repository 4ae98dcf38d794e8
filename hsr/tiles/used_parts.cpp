#include "hsr/tiles/used_parts.h"

#include <algorithm>

namespace hsr::internal {

namespace {

std::vector<std::uint32_t> numbers(const std::vector<char>& is_used) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < is_used.size(); ++i)
    if (is_used[i] != 0) all.push_back(i);
  return all;
}

}  // namespace

ModelPart UsedParts::part(const Mesh& mesh) {
  std::sort(wires_.begin(), wires_.end());
  std::vector<std::uint32_t> segments;
  const auto& all = part_.model.polygons.segments;
  for (std::uint32_t k = 0; k < all.size() && !wires_.empty(); ++k) {
    const std::uint32_t a = mesh.merged[VertexId(all[k][0])].value, b = mesh.merged[VertexId(all[k][1])].value;
    if (std::binary_search(wires_.begin(), wires_.end(), std::array{std::min(a, b), std::max(a, b)})) segments.push_back(k);
  }
  const std::vector<std::uint32_t> faces = numbers(faces_), points = numbers(points_);
  return part_of(part_, {faces, segments, points});
}

}  // namespace hsr::internal
