#include "hsr/view/section_cells.h"

namespace hsr::internal {

/// On plane i, which cell i sees, plane j > i is negative or zero, as what is taken away is in front of it; so is the fold of i and j there:
/// -i(eye) j(p), and i(eye) is negative. It is positive in cell j.
std::vector<SectionCell> section_cells(const View& view) {
  View uncut = view;
  uncut.planes.clear();
  uncut.far.reset();
  std::vector<std::uint8_t> facing, edge_on;
  for (std::size_t k = 0; k < view.planes.size(); ++k)
    (viewer_side(view, view.planes[k]) == Sign::zero ? edge_on : facing).push_back(static_cast<std::uint8_t>(k + 1));
  std::vector<SectionCell> cells;
  if (view.planes.empty()) cells.push_back({0, uncut, {}});
  // What planes seen edge-on leave: beside the first of them, else beside the second, and so on.
  for (std::size_t k = 0; k < edge_on.size(); ++k) {
    SectionCell cell{0, uncut, {}};
    for (std::size_t m = 0; m < k; ++m) cell.sides.push_back({edge_on[m], edge_on[m], Sign::negative});
    cell.sides.push_back({edge_on[k], edge_on[k], Sign::positive});
    cells.push_back(cell);
  }
  for (const std::uint8_t i : facing) {
    SectionCell cell{i, uncut, {}};
    cell.view.section = view.planes[i - 1U];
    for (const std::uint8_t k : edge_on) cell.sides.push_back({k, k, Sign::negative});
    for (const std::uint8_t j : facing) {
      if (j < i) cell.sides.push_back({j, i, Sign::positive});
      if (j > i) cell.sides.push_back({i, j, Sign::negative});
    }
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace hsr::internal
