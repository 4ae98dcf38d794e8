#pragma once

#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// Cuts convex pieces of an order at planes, by signs of predicates: no corner is ever a rounded number.
class PieceClipper {
 public:
  /// A plane that pieces are cut off at, and the side of it that is kept.
  struct Border {
    Cut cut;
    Plane plane;
    Sign kept;
  };

  /// @pre outlives it
  explicit PieceClipper(const ProjectedMesh& projected) : projected_(projected), exact_(projected.predicates()) {}

  Border border(const Cut& cut, Sign kept) const;
  /// Positive: on the side of the border that is kept. @param c of a piece of that facet
  Sign side(const Border& border, FacetId facet, const PieceCorner& c);
  /// What of a convex piece is on the side that is kept. False, and the corners as they were: nothing that has an area. What lies
  /// in the far plane of a view stays.
  bool keep(const Border& border, FacetId facet, std::vector<PieceCorner>& corners);

  const DecisionCounts& decisions() const { return exact_.counts(); }

 private:
  const ProjectedMesh& projected_;
  Predicates exact_;
  std::vector<Sign> sides_;  // of the corners
};

}  // namespace hsr::internal
