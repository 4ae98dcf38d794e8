#pragma once

#include <cstdint>
#include <vector>

#include "hsr/view/view.h"

namespace hsr::internal {

/// A side of a cell: the plane that planes u and v of the view make (View::fold_plane), and on which side of it the cell is.
struct CellSide {
  std::uint8_t u, v;
  Sign kept;
};

/// A part of the image of a view with several sections: a convex one, bounded by planes through the viewpoint.
///
/// What is in front of all planes is taken away, so along a line of sight what is left begins where the first of them is met. In each
/// cell that is one and the same plane: there the view is that with this plane as its only section.
struct SectionCell {
  std::uint8_t plane = 0;  ///< its number in the view; 0: nothing is taken away here, or `section` of the view
  View view;               ///< with this section alone, and no far plane
  std::vector<CellSide> sides;
};

/// The cells of a view. They cover all of the image that anything is left in, and share no more than their sides.
/// @pre view.has_cells()
std::vector<SectionCell> section_cells(const View& view);

}  // namespace hsr::internal
