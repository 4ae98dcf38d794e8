#include "hsr/painter/piece_clipper.h"

#include <algorithm>
#include <utility>

#include "hsr/symbols/constructions.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

PieceClipper::Border PieceClipper::border(const Cut& cut, Sign kept) const { return {cut, cut_plane(projected_, cut), kept}; }

Sign PieceClipper::side(const Border& border, FacetId facet, const PieceCorner& c) {
  if (c.vertex.is_valid()) return projected_.side(border.plane, c.vertex, exact_) * border.kept;
  return exact_.side(border.plane, projected_.face_plane(facet), cut_plane(projected_, c.a), cut_plane(projected_, c.b)) *
         border.kept;
}

bool PieceClipper::keep(const Border& border, FacetId facet, std::vector<PieceCorner>& corners) {
  sides_.clear();
  for (const PieceCorner& c : corners) sides_.push_back(side(border, facet, c));
  const auto is_any = [&](Sign sign) { return std::find(sides_.begin(), sides_.end(), sign) != sides_.end(); };
  if (!is_any(Sign::positive)) {
    // Beside the border; but what lies in the far plane stays.
    return border.cut.kind == Cut::Kind::near && border.cut.plane() == View::far_number && !is_any(Sign::negative);
  }
  if (!is_any(Sign::negative)) return true;
  std::vector<PieceCorner> left;
  const auto crossing = [&](const PieceCorner& from) {
    PieceCorner c = from;
    c.vertex = {};
    c.a = from.side;
    c.b = border.cut;
    return c;
  };
  const auto along_border = [&](PieceCorner c) {
    c.side = border.cut;
    c.original = false;
    return c;
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Sign here = sides_[k], next = sides_[(k + 1) % corners.size()];
    if (here == Sign::positive) left.push_back(corners[k]);
    if (here == Sign::zero) left.push_back(next == Sign::negative ? along_border(corners[k]) : corners[k]);
    if (here == Sign::positive && next == Sign::negative) left.push_back(along_border(crossing(corners[k])));
    if (here == Sign::negative && next == Sign::positive) left.push_back(crossing(corners[k]));
  }
  corners = std::move(left);
  return true;
}

}  // namespace hsr::internal
