#include "hsr/painter/sort/face_pieces.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "geometry/error.h"
#include "hsr/scene/facet.h"
#include "hsr/visibility_map/convex_ring.h"

namespace hsr::internal {

namespace {

void add_ring(FacePieces& pieces, FacetId facet, std::span<const VertexId> ring) {
  pieces.facet.push_back(facet);
  pieces.rings.push_row(ring);
}

void add(FacePieces& pieces, MapPredicates& map, FacetId facet) {
  const ProjectedMesh& projected = map.projected();
  const Mesh& mesh = map.mesh();
  const TriangleId end = facet_end(mesh, facet);
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U)) {
    if (!projected.reaches_before_near(t)) continue;
    for (ConvexPiece& shape : convex_pieces(map, facet)) {
      pieces.cut.push_back(static_cast<std::uint32_t>(pieces.size()));
      pieces.cut_shape.push_back(std::move(shape));
      add_ring(pieces, facet, {});
    }
    return;
  }
  if (triangle_count(mesh, facet) > 1) {
    const std::vector<VertexId> ring = convex_ring(projected, facet, map.exact());
    if (!ring.empty()) {
      add_ring(pieces, facet, ring);
      return;
    }
  }
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U))
    if (projected.reaches_beyond_near(t)) add_ring(pieces, facet, mesh.triangles[t]);
}

void append(FacePieces& all, FacePieces& part) {
  const auto first_piece = static_cast<std::uint32_t>(all.size());
  all.facet.insert(all.facet.end(), part.facet.begin(), part.facet.end());
  check_countable(all.rings.values().size() + part.rings.values().size(), "corners of faces");
  all.rings.append(part.rings);
  for (const std::uint32_t piece : part.cut) all.cut.push_back(first_piece + piece);
  std::move(part.cut_shape.begin(), part.cut_shape.end(), std::back_inserter(all.cut_shape));
}

}  // namespace

ConvexPiece FacePieces::shape(const ProjectedMesh& projected, std::size_t piece) const {
  const std::span<const VertexId> whole = rings[piece];
  if (!whole.empty()) return convex_piece(projected, first_triangle(facet[piece]), whole);
  return cut_shape[static_cast<std::size_t>(std::lower_bound(cut.begin(), cut.end(), piece) - cut.begin())];
}

FacePieces face_pieces(const ProjectedMesh& projected) {
  const Mesh& mesh = projected.mesh();
  constexpr std::size_t block = 4096;
  const std::size_t n = mesh.triangles.size();
  std::vector<FacePieces> parts((n + block - 1) / block);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    MapPredicates map(projected);
    for (std::size_t k = range.begin(); k != range.end(); ++k)
      for (std::size_t i = k * block; i < std::min(n, (k + 1) * block); ++i) {
        const TriangleId t(i);
        if (is_first(mesh, t) && projected.facing(t) != Sign::zero) add(parts[k], map, FacetId(t.value));
      }
  });
  FacePieces all;
  all.facet.reserve(n);
  all.rings.reserve(n, 3 * n);
  for (FacePieces& part : parts) append(all, part);
  return all;
}

}  // namespace hsr::internal
