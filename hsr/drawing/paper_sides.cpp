#include "hsr/drawing/paper_sides.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/parallel.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

namespace {

/// Thousandths of a millimetre: the rounding of a corner and of both ends of a side.
constexpr double rounding = 1.5;

/// A side whichever way it runs.
struct SideKey {
  PaperPoint low, high;
  std::uint32_t side = 0;
  bool is_reversed = false;

  explicit SideKey() = default;
  SideKey(const PaperSide& s, std::uint32_t index)
      : low(std::min(s.from, s.to)), high(std::max(s.from, s.to)), side(index), is_reversed(s.to < s.from) {}
  bool is_at(const SideKey& other) const { return low == other.low && high == other.high; }
  friend bool operator<(const SideKey& a, const SideKey& b) {
    return std::tie(a.low, a.high, a.is_reversed, a.side) < std::tie(b.low, b.high, b.is_reversed, b.side);
  }
};

/// Those beside which no side runs the other way between the same points.
std::vector<std::uint32_t> without_opposite(const std::vector<PaperSide>& sides) {
  std::vector<SideKey> keys(sides.size());
  parallel_for_each(keys.size(), [&](std::size_t k) { keys[k] = SideKey(sides[k], static_cast<std::uint32_t>(k)); });
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> single;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t end = i;
    while (end < keys.size() && keys[end].is_at(keys[i])) ++end;
    if (keys[i].is_reversed == keys[end - 1].is_reversed)
      for (std::size_t k = i; k < end; ++k) single.push_back(keys[k].side);
    i = end;
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

std::vector<std::vector<PaperPoint>> united_rings(std::vector<PaperSide> sides) {
  const auto key = [](const PaperSide& s) { return std::pair(std::min(s.from, s.to), std::max(s.from, s.to)); };
  std::sort(sides.begin(), sides.end(), [&](const PaperSide& a, const PaperSide& b) { return key(a) < key(b); });
  std::vector<PaperSide> left;
  for (std::size_t i = 0; i < sides.size();) {
    const auto at = key(sides[i]);
    int forward = 0;
    for (; i < sides.size() && key(sides[i]) == at; ++i) forward += sides[i].from == at.first ? 1 : -1;
    const PaperSide side = forward > 0 ? PaperSide{at.first, at.second} : PaperSide{at.second, at.first};
    left.insert(left.end(), static_cast<std::size_t>(std::abs(forward)), side);
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
