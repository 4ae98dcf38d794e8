#pragma once

#include <cstdint>

#include "hsr/painter/sort/sort_observer.h"
#include "hsr/painter/sort/whole_overlap.h"

namespace hsr::internal {

/// The relations of one piece after another with others: of whole pieces where vertices tell, else of their shapes. One object
/// per thread.
class PieceRelations {
 public:
  PieceRelations(const ProjectedMesh& projected, const FacePieces& pieces, const ImageTriangles& images, bool classic)
      : projected_(projected), pieces_(pieces), overlaps_(projected, classic), whole_(projected, pieces, images) {}

  Overlap relation(std::uint32_t i, std::uint32_t k);
  /// The same, told.
  Overlap relation(std::uint32_t i, std::uint32_t k, SortObserver& observer);

  OverlapCounts counts() const;
  DecisionCounts decisions();

 private:
  void turn_to(std::uint32_t i);
  PieceOfFacet shape(std::uint32_t i) const;

  const ProjectedMesh& projected_;
  const FacePieces& pieces_;
  Overlaps overlaps_;
  WholeOverlaps whole_;
  std::uint32_t first_ = 0xffffffffU;
  bool is_whole_ = false;
  PieceOfFacet shape_;  // of the first, where it is asked for
};

}  // namespace hsr::internal
