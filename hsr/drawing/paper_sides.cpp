#include "hsr/drawing/paper_sides.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/parallel.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

namespace {

/// Thousandths of a millimetre: the rounding of a corner and of both ends of a side.
constexpr double rounding = 1.5;

/// Those beside which no side runs the other way between the same points.
std::vector<std::uint32_t> without_opposite(const std::vector<PaperSide>& sides) {
  const std::vector<SideKey> keys = sorted_keys(sides);
  std::vector<std::uint32_t> single;
  for (std::size_t i = 0, end = 0; i < keys.size(); i = end) {
    bool is_alone = true;
    for (; end < keys.size() && keys[end].is_at(keys[i]); ++end)
      is_alone = is_alone && keys[end].is_reversed == keys[i].is_reversed;
    for (std::size_t k = i; is_alone && k < end; ++k) single.push_back(keys[k].side);
  }
  std::sort(single.begin(), single.end());
  return single;
}

ImageBox box_around(const std::array<double, 2>& p, const std::array<double, 2>& q) {
  ImageBox box = ImageBox::nothing();
  for (const auto& r : {p, q}) box.add({r[0], r[1], 0}, {2 * rounding, 2 * rounding, 0});
  return box;
}

/// The corners of sides, to be found by place.
class Corners {
 public:
  Corners(const std::vector<PaperSide>& sides, const std::vector<std::uint32_t>& of) {
    for (const std::uint32_t k : of) {
      points_.push_back(sides[k].from);
      points_.push_back(sides[k].to);
    }
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    std::vector<ImageBox> boxes;
    ImageBox all = ImageBox::nothing();
    for (const PaperPoint& p : points_) {
      const std::array<double, 2> at = {static_cast<double>(p.x), static_cast<double>(p.y)};
      boxes.push_back(box_around(at, at));
      all.add(boxes.back());
    }
    if (!points_.empty()) step_ = std::max(1.0F, std::max(all.high[0] - all.low[0], all.high[1] - all.low[1]) / 256);
    tree_ = BoxTree(boxes);
  }

  /// Appends those that lie on the side between its ends, from its start on.
  void find_on(const PaperSide& side, std::vector<PaperPoint>& found) const {
    const double x = static_cast<double>(side.to.x - side.from.x), y = static_cast<double>(side.to.y - side.from.y);
    const double length = std::hypot(x, y);
    const std::size_t first = found.size();
    const auto at = [&](double t) {
      return std::array{static_cast<double>(side.from.x) + t * x, static_cast<double>(side.from.y) + t * y};
    };
    // In boxes along the side: that around a long slanting one would hold much that is nowhere near it.
    const double parts = std::max(1.0, std::ceil(length / step_));
    for (double k = 0; k < parts; ++k)
      tree_.visit_touching(box_around(at(k / parts), at((k + 1) / parts)), [&](std::uint32_t i) {
        const PaperPoint& p = points_[i];
        const double u = static_cast<double>(p.x - side.from.x), v = static_cast<double>(p.y - side.from.y);
        const double along = (u * x + v * y) / length, across = std::fabs(x * v - y * u) / length;
        if (across <= rounding && along > 0 && along < length && p != side.from && p != side.to) found.push_back(p);
        return true;
      });
    const auto place = [&](const PaperPoint& p) {
      return static_cast<double>(p.x - side.from.x) * x + static_cast<double>(p.y - side.from.y) * y;
    };
    const auto begin = found.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, found.end(),
              [&](const PaperPoint& p, const PaperPoint& q) { return std::pair(place(p), p) < std::pair(place(q), q); });
    found.erase(std::unique(begin, found.end()), found.end());
  }

 private:
  std::vector<PaperPoint> points_;
  BoxTree tree_;
  double step_ = 1;
};

}  // namespace

void append_sides(std::span<const PaperPoint> ring, std::uint32_t owner, std::vector<PaperSide>& sides, std::uint32_t number) {
  for (std::size_t k = 0; k < ring.size(); ++k) sides.push_back({ring[k], ring[(k + 1) % ring.size()], owner, number});
}

std::vector<SideKey> sorted_keys(const std::vector<PaperSide>& sides) {
  std::vector<SideKey> keys(sides.size());
  parallel_for_each(keys.size(), [&](std::size_t k) {
    const PaperSide& s = sides[k];
    keys[k] = {std::min(s.from, s.to), std::max(s.from, s.to), static_cast<std::uint32_t>(k), s.to < s.from};
  });
  tbb::parallel_sort(keys.begin(), keys.end(), [](const SideKey& a, const SideKey& b) {
    return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side);
  });
  return keys;
}

std::vector<PaperSide> conforming(const std::vector<PaperSide>& sides) {
  const std::vector<std::uint32_t> single = without_opposite(sides);
  const Corners corners(sides, single);
  std::vector<std::vector<PaperPoint>> inner(single.size());
  parallel_for_each(single.size(), [&](std::size_t k) { corners.find_on(sides[single[k]], inner[k]); });
  std::vector<PaperSide> cut;
  cut.reserve(sides.size());
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < sides.size(); ++k) {
    PaperPoint from = sides[k].from;
    if (next < single.size() && single[next] == k)
      for (const PaperPoint& p : inner[next++]) {
        cut.push_back({from, p, sides[k].owner, sides[k].ring});
        from = p;
      }
    cut.push_back({from, sides[k].to, sides[k].owner, sides[k].ring});
  }
  return cut;
}

std::vector<std::vector<PaperPoint>> united_rings(const std::vector<PaperSide>& sides) {
  const std::vector<SideKey> keys = sorted_keys(sides);
  std::vector<PaperSide> left;
  for (std::size_t i = 0, end = 0; i < keys.size(); i = end) {
    int forward = 0;
    for (; end < keys.size() && keys[end].is_at(keys[i]); ++end) forward += keys[end].is_reversed ? -1 : 1;
    const auto& [low, high, side, is_reversed] = keys[i];
    if (low == high) continue;
    left.insert(left.end(), static_cast<std::size_t>(std::abs(forward)),
                forward > 0 ? PaperSide{low, high} : PaperSide{high, low});
  }
  std::sort(left.begin(), left.end());
  std::vector<char> used(left.size(), 0);
  std::vector<std::vector<PaperPoint>> rings;
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (used[first] != 0) continue;
    std::vector<PaperPoint>& ring = rings.emplace_back();
    for (std::size_t k = first; k < left.size() && used[k] == 0;) {
      used[k] = 1;
      ring.push_back(left[k].from);
      k = static_cast<std::size_t>(std::lower_bound(left.begin(), left.end(), left[k].to,
                                                    [](const PaperSide& s, const PaperPoint& p) { return s.from < p; }) -
                                   left.begin());
      while (k < left.size() && used[k] != 0 && k + 1 < left.size() && left[k + 1].from == left[k].from) ++k;
    }
  }
  return rings;
}

}  // namespace hsr::internal
