#include "hsr/painter/sort/image_pieces.h"

#include <algorithm>

#include "geometry/error.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

/// What cuts the facet's plane along a line of the map.
Cut cut_of(const MapLine& line, FacetId facet) {
  switch (line.kind) {
    case MapLine::Kind::edge:
      return {Cut::Kind::sight, 0, line.u, line.v};
    case MapLine::Kind::near:
      return {Cut::Kind::near, 0, 0, 0};
    case MapLine::Kind::meet:
    case MapLine::Kind::fold:
      break;
  }
  return {Cut::Kind::face, 0, line.u == facet.value ? line.v : line.u, 0};
}

/// Whether the line carries an edge of the face.
bool is_original(const Mesh& mesh, FacetId facet, const MapLine& line) {
  if (line.kind != MapLine::Kind::edge) return false;
  for (TriangleId t = first_triangle(facet); t < facet_end(mesh, facet); t = TriangleId(t.value + 1U)) {
    const auto& c = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (MapLine::edge(c[k], c[(k + 1) % 3]) == line) return is_edge_of_face(mesh, t, k);
  }
  return false;
}

}  // namespace

void append(const Mesh& mesh, const PieceOfFacet& piece, PaintersOrder& order) {
  OrderedPiece out{piece.facet, static_cast<std::uint32_t>(order.corners.size()), 0};
  for (std::size_t k = 0; k < piece.shape.points.size(); ++k) {
    const MapPoint& p = piece.shape.points[k];
    const MapLine& line = piece.shape.lines[k].line;
    PieceCorner c;
    if (p.is_vertex) {
      c.vertex = p.vertex;
    } else {
      c.a = cut_of(p.l, piece.facet);
      c.b = cut_of(p.m, piece.facet);
    }
    c.side = cut_of(line, piece.facet);
    c.original = is_original(mesh, piece.facet, line);
    order.corners.push_back(c);
  }
  check_countable(order.corners.size(), "corners of a painting order");
  out.end_corner = static_cast<std::uint32_t>(order.corners.size());
  order.pieces.push_back(out);
}

void append(const ProjectedMesh& projected, const FacePieces& pieces, std::size_t piece, PaintersOrder& order) {
  const Mesh& mesh = projected.mesh();
  const FacetId facet = pieces.facet[piece];
  const std::span<const VertexId> ring = pieces.rings[piece];
  if (ring.empty()) {
    append(mesh, {facet, pieces.shape(projected, piece)}, order);
    return;
  }
  const bool forward = projected.facing(facet) == Sign::positive;
  const std::size_t n = ring.size();
  const bool is_face = goes_around_face(mesh, facet, n);
  OrderedPiece out{facet, static_cast<std::uint32_t>(order.corners.size()), 0};
  for (std::size_t k = 0; k < n; ++k) {
    const VertexId u = ring[forward ? k : n - 1 - k], v = ring[forward ? (k + 1) % n : (2 * n - 2 - k) % n];
    const MapLine line = MapLine::edge(u, v);
    PieceCorner& c = order.corners.emplace_back();
    c.vertex = u;
    c.side = {Cut::Kind::sight, 0, line.u, line.v};
    c.original = is_face || is_original(mesh, facet, line);
  }
  out.end_corner = static_cast<std::uint32_t>(order.corners.size());
  order.pieces.push_back(out);
}

}  // namespace hsr::internal
