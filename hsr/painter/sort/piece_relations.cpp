#include "hsr/painter/sort/piece_relations.h"

namespace hsr::internal {

Overlap PieceRelations::relation(std::uint32_t i, std::uint32_t k) {
  if (i != first_) turn_to(i);
  if (is_whole_ && !pieces_.rings[k].empty())
    if (const auto how = whole_.relation(k)) return *how;
  if (shape_.shape.points.empty()) shape_ = shape(i);
  return overlaps_.relation(shape_, shape(k));
}

OverlapCounts PieceRelations::counts() const {
  OverlapCounts all = overlaps_.counts();
  all += whole_.counts();
  return all;
}

DecisionCounts PieceRelations::decisions() {
  DecisionCounts all = overlaps_.map().exact().counts();
  all += whole_.decisions();
  return all;
}

void PieceRelations::turn_to(std::uint32_t i) {
  first_ = i;
  shape_ = {};
  is_whole_ = !pieces_.rings[i].empty();
  if (is_whole_) whole_.turn_to(i);
}

PieceOfFacet PieceRelations::shape(std::uint32_t i) const {
  PieceOfFacet piece{pieces_.facet[i], pieces_.shape(projected_, i)};
  piece.near = overlaps_.near_corners(piece);
  return piece;
}

}  // namespace hsr::internal
