#pragma once

#include <cstddef>
#include <span>

#include "hsr/surfaces/line_envelope.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::internal {

/// Is told how visible fragments are found, in the order in which that is done: the sides along the lines of the map first, then, facet by
/// facet, how sides become rings.
class FragmentObserver {
 public:
  FragmentObserver() = default;
  FragmentObserver(const FragmentObserver&) = delete;
  FragmentObserver& operator=(const FragmentObserver&) = delete;
  virtual ~FragmentObserver() = default;

  /// What is seen just to the left and just to the right of a part of a line, from its beginning to its end.
  /// @param right empty where two faces pierce each other: where one of them is seen on the left, the other one is on the right
  virtual void looked_beside(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right) = 0;
  /// What is seen differs there: a side of a fragment, on its left.
  virtual void added_side(FacetId facet, const MapSide& side) = 0;
  /// The sides of a facet are to be linked.
  virtual void linking(FacetId facet, std::size_t sides) = 0;
  /// They were cut at the points on them, and what lay there both ways has cancelled.
  virtual void cut_sides(std::size_t pieces, std::size_t left) = 0;
  /// A walk along them closed.
  virtual void closed_ring(std::span<const MapCorner> corners, bool is_outer) = 0;
  /// A fragment of the facet. @param rings the outer one first
  virtual void found(FacetId facet, std::span<const std::span<const MapCorner>> rings) = 0;
};

/// visible_fragments(), watched, in one thread: it does the same and gives the same. @pre the view has no cells
VisibleFragments visible_fragments(const SceneView& scene, const FragmentOptions& options, FragmentObserver& observer);

}  // namespace hsr::internal
