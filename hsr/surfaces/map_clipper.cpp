#include "hsr/surfaces/map_clipper.h"

#include <algorithm>
#include <utility>

namespace hsr::internal {

/// A line just beside comes into the part where a side leads to the line, and leaves it where one leads away. A side that runs along the
/// line with the part kept on its left is led to and led away from: what it bounds is taken out.
void MapClipper::keep(const MapLine& line, Sign kept, std::vector<MapSide>& sides) {
  std::vector<MapSide> left;
  ends_.clear();
  for (MapSide side : sides) {
    const Sign from = map_.side(line, side.from) * kept, to = map_.side(line, side.to) * kept;
    if (from != Sign::positive && to != Sign::positive) {
      const bool runs_along = from == Sign::zero && to == Sign::zero;
      if (!runs_along || map_.order(line, side.from, side.to) * kept != Sign::negative) continue;
    }
    if (from == Sign::negative) side.from = MapPoint::crossing(line, side.line);
    if (to == Sign::negative) side.to = MapPoint::crossing(line, side.line);
    if (from != Sign::positive) ends_.push_back({side.from, -1});
    if (to != Sign::positive) ends_.push_back({side.to, 1});
    left.push_back(side);
  }
  // Along the line with what is kept on the left.
  std::stable_sort(ends_.begin(), ends_.end(),
                   [&](const End& x, const End& y) { return map_.order(line, x.at, y.at) * kept == Sign::negative; });
  int within = 0;
  for (std::size_t k = 0; k < ends_.size(); ++k) {
    within += ends_[k].change;
    if (within > 0 && map_.order(line, ends_[k].at, ends_[k + 1].at) != Sign::zero)
      left.push_back({line, kept == Sign::negative, ends_[k].at, ends_[k + 1].at});
  }
  sides = std::move(left);
}

}  // namespace hsr::internal
