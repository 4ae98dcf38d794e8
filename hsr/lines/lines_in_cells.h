#pragma once

#include <cstdint>
#include <vector>

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"
#include "hsr/view/section_cells.h"

namespace hsr::internal {

/// A plane that cuts off what is not on one side of it.
struct CutSide {
  Cut cut;
  Sign kept;
};

/// The lines of one cell, and by what they are cut off.
struct LinesOfCell {
  VisibleLines lines;
  std::uint8_t plane;  ///< its number in the view: what the lines call the near plane
  std::vector<CutSide> sides;
};

std::vector<CutSide> sides_of(const SectionCell& cell);

/// The lines of all cells, cut off at their sides, as one line wherever they go on. @pre there is a cell
VisibleLines united_lines(const SceneView& scene, const std::vector<LinesOfCell>& cells, const LineOptions& options);

/// The visible lines of a view with several sections, or with a far plane: those of each cell, cut off at its sides, as one line wherever
/// they go on. A line along a side of two cells is hidden where it is in one of them.
/// @pre scene.view().has_cells()
/// Exact: yes. Cost: that of the visible lines of each cell.
VisibleLines lines_in_cells(const SceneView& scene, const LineOptions& options);

}  // namespace hsr::internal
