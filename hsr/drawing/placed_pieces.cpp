#include "hsr/drawing/placed_pieces.h"

#include "hsr/drawing/paper_rings.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

PlacedPiece PiecePlacer::operator()(const OrderedPiece& piece, std::span<const PieceCorner> corners,
                                    const std::vector<std::optional<EdgeClass>>* asked) const {
  std::vector<HomogeneousPoint> at;
  std::vector<std::array<Wide, 2>> ring;
  bool is_inside = true;
  for (const PieceCorner& corner : corners) {
    at.push_back(enclosed(piece.facet, corner));
    const HomogeneousPoint& p = at.back();
    ring.push_back({p.x.middle / p.w.middle, p.y.middle / p.w.middle});
    is_inside = is_inside && (!frame_ || is_in_frame(ring.back()));
  }
  PlacedPiece placed;
  if (is_inside)
    for (std::size_t k = 0; k < corners.size(); ++k) placed.ring.push_back(rounded(piece.facet, corners[k], at[k]));
  for (std::size_t k = 0; asked != nullptr && k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const auto edge_class = class_of_side(corners[k], *asked);
    if (!edge_class) continue;
    if (is_inside)
      placed.lines.push_back({placed.ring[k], placed.ring[next], *edge_class});
    else
      add_clipped(ring[k], ring[next], *edge_class, placed.lines);
  }
  if (!is_inside) placed.ring = clipped(std::move(ring), *frame_);
  drop_repeated(placed.ring);
  return placed;
}

std::vector<PaperPoint> PiecePlacer::operator()(const OrderedWire& wire) const {
  std::vector<PaperPoint> ends;
  std::vector<std::array<Wide, 2>> at;
  for (const auto& end : exact_ends(mesh_, wire)) {
    const std::array<Rational, 2> p = projection_.exact(end);
    ends.push_back(Projection::rounded(p));
    at.push_back({enclose(p[0]).middle, enclose(p[1]).middle});
  }
  if (frame_ && !(is_in_frame(at[0]) && is_in_frame(at[1]))) {
    ends = clipped(at, *frame_);
    if (ends.size() > 2) ends.resize(2);  // the way back is another line
  }
  if (ends.size() == 2 && ends[0] == ends[1]) ends.clear();
  return ends;
}

bool PiecePlacer::is_in_frame(const std::array<Wide, 2>& p) const {
  return p[0] >= frame_->left && p[0] <= frame_->right && p[1] >= frame_->top && p[1] <= frame_->bottom;
}

/// Sides that cuts made are no lines.
std::optional<EdgeClass> PiecePlacer::class_of_side(const PieceCorner& corner,
                                                    const std::vector<std::optional<EdgeClass>>& asked) const {
  const bool is_edge = corner.side.kind == Cut::Kind::sight || corner.side.kind == Cut::Kind::line;
  if (!corner.original || !is_edge) return {};
  const EdgeId e = mesh_.find_edge(VertexId(corner.side.u), VertexId(corner.side.v));
  return e.is_valid() ? asked[e.value] : std::optional<EdgeClass>();
}

void PiecePlacer::add_clipped(const std::array<Wide, 2>& from, const std::array<Wide, 2>& to, EdgeClass edge_class,
                              std::vector<SideLine>& lines) const {
  for (const std::vector<PaperPoint> ends = clipped({from, to}, *frame_); const PaperPoint& p : ends)
    if (p != ends.front()) {
      lines.push_back({ends.front(), p, edge_class});
      return;
    }
}

PaperPoint PiecePlacer::rounded(FacetId facet, const PieceCorner& corner, const HomogeneousPoint& at) const {
  if (const auto known = Projection::rounded(at)) return *known;
  return Projection::rounded(projection_.exact(exact_point(mesh_, view_, facet, corner)));
}

HomogeneousPoint PiecePlacer::enclosed(FacetId facet, const PieceCorner& corner) const {
  if (corner.vertex.is_valid()) return projection_.at(corner.vertex);
  const auto& c = mesh_.triangles[first_triangle(facet)];
  return projection_.at(Plane::of_face(mesh_.points[c[0]], mesh_.points[c[1]], mesh_.points[c[2]]),
                        plane_of(mesh_, view_, corner.a), plane_of(mesh_, view_, corner.b));
}

}  // namespace hsr::internal
