#include "hsr/visibility_map/convex_piece.h"

#include <algorithm>

#include "hsr/scene/facet.h"
#include "hsr/visibility_map/convex_ring.h"

namespace hsr::internal {

ConvexPiece convex_piece(const ProjectedMesh& projected, TriangleId t) {
  return convex_piece(projected, t, projected.mesh().triangles[t]);
}

ConvexPiece convex_piece(const ProjectedMesh& projected, TriangleId t, std::span<const VertexId> ring) {
  ConvexPiece piece;
  const bool forward = projected.facing(t) == Sign::positive;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const VertexId u = ring[forward ? k : n - 1 - k], v = ring[forward ? (k + 1) % n : (2 * n - 2 - k) % n];
    piece.points.push_back(MapPoint::of_vertex(u));
    piece.lines.push_back({MapLine::edge(u, v), u < v ? Sign::positive : Sign::negative});
  }
  return piece;
}

std::vector<ConvexPiece> convex_pieces(MapPredicates& map, FacetId facet) {
  const ProjectedMesh& projected = map.projected();
  const TriangleId end = facet_end(map.mesh(), facet);
  std::vector<ConvexPiece> pieces;
  if (triangle_count(map.mesh(), facet) > 1)
    if (const auto ring = convex_ring(projected, facet, map.exact()); !ring.empty())
      pieces.push_back(convex_piece(projected, first_triangle(facet), ring));
  if (pieces.empty())
    for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U))
      if (projected.reaches_beyond_near(t)) pieces.push_back(convex_piece(projected, t));
  bool near_cuts = false;
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U))
    near_cuts = near_cuts || projected.reaches_before_near(t);
  if (near_cuts) {
    for (ConvexPiece& piece : pieces) cut(map, piece, beyond_near(projected, first_triangle(facet)));
    std::erase_if(pieces, [](const ConvexPiece& p) { return p.points.empty(); });
  }
  return pieces;
}

std::optional<ConvexPiece> cut(MapPredicates& map, ConvexPiece& piece, const MapHalfPlane& h) {
  const std::size_t n = piece.points.size();
  std::vector<Sign> at;
  bool inside = false, outside = false;
  for (const MapPoint& p : piece.points) {
    at.push_back(map.side(h.line, p) * h.inner);
    inside = inside || at.back() == Sign::positive;
    outside = outside || at.back() == Sign::negative;
  }
  if (!outside) return std::nullopt;
  if (!inside) {
    ConvexPiece all = std::move(piece);
    piece = {};
    return all;
  }
  // The part of the piece on one side of the line: where it leaves, the line takes over until it comes back.
  const auto part = [&](Sign wanted) {
    ConvexPiece out;
    for (std::size_t k = 0; k < n; ++k) {
      const Sign here = at[k] * wanted, next = at[(k + 1) % n] * wanted;
      const MapPoint crossing = MapPoint::crossing(piece.lines[k].line, h.line);
      const MapHalfPlane border = {h.line, h.inner * wanted};
      if (here == Sign::positive) {
        out.points.push_back(piece.points[k]);
        out.lines.push_back(piece.lines[k]);
        if (next == Sign::negative) {
          out.points.push_back(crossing);
          out.lines.push_back(border);
        }
      } else if (here == Sign::zero) {
        out.points.push_back(piece.points[k]);
        out.lines.push_back(next == Sign::positive ? piece.lines[k] : border);
      } else if (next == Sign::positive) {
        out.points.push_back(crossing);
        out.lines.push_back(piece.lines[k]);
      }
    }
    return out;
  };
  ConvexPiece outer = part(Sign::negative);
  piece = part(Sign::positive);
  return outer;
}

}  // namespace hsr::internal
