#include "hsr/painter/sort/piece_relations.h"

namespace hsr::internal {

Overlap PieceRelations::relation(std::uint32_t i, std::uint32_t k) {
  if (i != first_) turn_to(i);
  if (is_whole_ && !pieces_.rings[k].empty())
    if (const auto how = whole_.relation(k)) return *how;
  if (shape_.shape.points.empty()) shape_ = shape(i);
  return overlaps_.relation(shape_, shape(k));
}

namespace {

/// The one that counted since.
SortTest decided(const OverlapCounts& before, const OverlapCounts& now) {
  return now.image_sides > before.image_sides       ? SortTest::image_sides
         : now.depths > before.depths               ? SortTest::depths
         : now.first_planes > before.first_planes   ? SortTest::plane_of_first
         : now.second_planes > before.second_planes ? SortTest::plane_of_second
         : now.coplanar > before.coplanar           ? SortTest::coplanar
                                                    : SortTest::common_part;
}

}  // namespace

Overlap PieceRelations::relation(std::uint32_t i, std::uint32_t k, SortObserver& observer) {
  const OverlapCounts before = counts();
  const Overlap how = relation(i, k);
  observer.compared(i, k, decided(before, counts()), how);
  return how;
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
