#pragma once

#include <cstdint>

#include "hsr/painter/sort/whole_overlap.h"

namespace hsr {

/// The relations of one piece after another with others: of whole pieces where vertices tell, else of their shapes. One object
/// per thread.
class PieceRelations {
 public:
  PieceRelations(const Sight& sight, const FacePieces& pieces, const ImageTriangles& images, bool classic)
      : sight_(sight), pieces_(pieces), overlaps_(sight, classic), whole_(sight, pieces, images) {}

  Overlap relation(std::uint32_t i, std::uint32_t k);

  OverlapCounts counts() const;
  DecisionCounts decisions();

 private:
  void turn_to(std::uint32_t i);
  PieceOfFacet shape(std::uint32_t i) const;

  const Sight& sight_;
  const FacePieces& pieces_;
  Overlaps overlaps_;
  WholeOverlaps whole_;
  std::uint32_t first_ = 0xffffffffU;
  bool is_whole_ = false;
  PieceOfFacet shape_;  // of the first, where it is asked for
};

}  // namespace hsr
