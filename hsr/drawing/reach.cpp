#include "hsr/drawing/reach.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/index.h"
#include "geometry/parallel.h"
#include "hsr/drawing/paper_sides.h"

namespace hsr::internal {

namespace {

using Pair = std::array<std::uint32_t, 2>;  // fills: the one that reaches beneath the other

std::vector<PaperSide> sides_of(const Fills& fills) {
  std::vector<PaperSide> sides;
  sides.reserve(fills.points.size());
  for (std::uint32_t i = 0; i < fills.fills.size(); ++i)
    for (std::uint32_t r = fills.fills[i].first_ring; r < fills.fills[i].end_ring; ++r) {
      const auto ring = fills.ring(r);
      for (std::size_t k = 0; k < ring.size(); ++k) sides.push_back({ring[k], ring[(k + 1) % ring.size()], i});
    }
  return sides;
}

/// Two fills with a side in common, and one of its ends.
struct Meeting {
  PaperPoint at;
  std::uint32_t earlier = 0, later = 0;
  friend constexpr auto operator<=>(const Meeting&, const Meeting&) = default;
};

class Neighbours {
 public:
  Neighbours(const Fills& fills, const std::vector<PaperSide>& sides) : fills_(fills) {
    find_along_sides(sides);
    find_at_corners();
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  }
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  /// Or so nearly that what lies beneath adds less than can be seen.
  bool is_opaque(std::uint32_t fill) const { return fills_.fills[fill].opacity >= 0.99; }
  /// The later one covers it: it is opaque, or part of the same sheet, which is painted opaque.
  bool may_reach(std::uint32_t earlier, std::uint32_t later) const {
    const Fill &a = fills_.fills[earlier], &b = fills_.fills[later];
    return is_opaque(later) || (a.layer == b.layer && a.opacity == b.opacity);
  }

  void find_along_sides(const std::vector<PaperSide>& sides) {
    struct Key {
      PaperPoint low, high;
      std::uint32_t owner;
      bool is_reversed;
    };
    std::vector<Key> keys(sides.size());
    parallel_for_each(keys.size(), [&](std::size_t k) {
      const PaperSide& s = sides[k];
      keys[k] = {std::min(s.from, s.to), std::max(s.from, s.to), s.owner, s.to < s.from};
    });
    tbb::parallel_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return std::tie(a.low, a.high, a.owner, a.is_reversed) < std::tie(b.low, b.high, b.owner, b.is_reversed);
    });
    for (std::size_t i = 0; i < keys.size();) {
      std::size_t end = i;
      while (end < keys.size() && keys[end].low == keys[i].low && keys[end].high == keys[i].high) ++end;
      // On either side, what an opaque one covers that is painted later needs nothing: the last opaque one, and those after it.
      std::array<std::vector<std::uint32_t>, 2> beside;
      for (std::size_t k = i; k < end; ++k) {
        std::vector<std::uint32_t>& on = beside[keys[k].is_reversed ? 1 : 0];
        if (is_opaque(keys[k].owner)) on.clear();
        on.push_back(keys[k].owner);
      }
      // Layers ascend, as they are painted one after the other; two sheets meet where they have one.
      const auto meet = [&](std::uint32_t p, std::uint32_t q) {
        if (p == q) return;
        meetings_.push_back({keys[i].low, std::min(p, q), std::max(p, q)});
        meetings_.push_back({keys[i].high, std::min(p, q), std::max(p, q)});
      };
      const auto layer = [&](std::uint32_t fill) { return fills_.fills[fill].layer; };
      for (const std::uint32_t p : beside[0]) {
        for (auto q = std::lower_bound(beside[1].begin(), beside[1].end(), layer(p),
                                       [&](std::uint32_t fill, std::uint32_t value) { return layer(fill) < value; });
             q != beside[1].end() && layer(*q) == layer(p); ++q)
          meet(p, *q);
        if (!beside[1].empty()) meet(p, beside[1].front());
      }
      for (const std::uint32_t q : beside[1])
        if (!beside[0].empty()) meet(beside[0].front(), q);
      i = end;
    }
    for (const Meeting& m : meetings_)
      if (may_reach(m.earlier, m.later)) pairs_.push_back({m.earlier, m.later});
  }

  /// Of the fills around a corner, one side after the other, the earliest; not of those that are only seen there by chance.
  void find_at_corners() {
    tbb::parallel_sort(meetings_.begin(), meetings_.end());
    std::vector<std::uint32_t> around;
    DisjointSets together;
    const auto place = [&](std::uint32_t fill) {
      return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), fill) - around.begin());
    };
    for (std::size_t i = 0, end = 0; i < meetings_.size(); i = end) {
      around.clear();
      for (; end < meetings_.size() && meetings_[end].at == meetings_[i].at; ++end)
        around.insert(around.end(), {meetings_[end].earlier, meetings_[end].later});
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      if (around.size() < 3) continue;
      together.reset(around.size());
      for (std::size_t k = i; k < end; ++k) together.join(place(meetings_[k].earlier), place(meetings_[k].later));
      for (std::uint32_t k = 0; k < around.size(); ++k)
        if (const std::uint32_t first = together.find(k); first != k && may_reach(around[first], around[k]))
          pairs_.push_back({around[first], around[k]});
    }
  }

  const Fills& fills_;
  std::vector<Meeting> meetings_;
  std::vector<Pair> pairs_;
};

}  // namespace

void reach_beneath(Fills& fills) {
  const std::vector<PaperSide> sides = conforming(sides_of(fills));
  const std::vector<Pair> pairs = Neighbours(fills, sides).pairs();
  // Sides, and pairs, by fill: both ascend.
  std::vector<std::size_t> first_side(fills.fills.size() + 1, 0), first_pair(fills.fills.size() + 1, 0);
  for (const PaperSide& s : sides) ++first_side[s.owner + 1];
  for (const Pair& p : pairs) ++first_pair[p[0] + 1];
  std::partial_sum(first_side.begin(), first_side.end(), first_side.begin());
  std::partial_sum(first_pair.begin(), first_pair.end(), first_pair.begin());
  std::vector<std::vector<std::vector<PaperPoint>>> united(fills.fills.size());
  parallel_for_each(united.size(), [&](std::size_t i) {
    if (first_pair[i] == first_pair[i + 1]) return;
    std::vector<PaperSide> together;
    const auto add = [&](std::size_t fill) {
      together.insert(together.end(), sides.begin() + static_cast<std::ptrdiff_t>(first_side[fill]),
                      sides.begin() + static_cast<std::ptrdiff_t>(first_side[fill + 1]));
    };
    add(i);
    for (std::size_t k = first_pair[i]; k < first_pair[i + 1]; ++k) add(pairs[k][1]);
    united[i] = united_rings(std::move(together));
  });
  Fills out;
  out.faces = std::move(fills.faces);
  out.lines = std::move(fills.lines);
  out.line_points = std::move(fills.line_points);
  const auto append = [&](std::span<const PaperPoint> ring) {
    out.points.insert(out.points.end(), ring.begin(), ring.end());
    check_countable(out.points.size(), "corners of fills");
    out.first_point.push_back(static_cast<std::uint32_t>(out.points.size()));
  };
  for (std::size_t i = 0; i < united.size(); ++i) {
    Fill fill = fills.fills[i];
    const std::uint32_t first = out.rings();
    if (united[i].empty())
      for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) append(fills.ring(r));
    for (const auto& ring : united[i]) append(ring);
    fill.first_ring = first;
    fill.end_ring = out.rings();
    out.fills.push_back(fill);
  }
  fills = std::move(out);
}

void sort_by_corners(Fills& fills) {
  const auto corners = [&](const Fill& f) { return fills.first_point[f.end_ring] - fills.first_point[f.first_ring]; };
  std::map<std::uint32_t, std::uint32_t> most;  // of each object's fills
  for (const Fill& f : fills.fills) {
    std::uint32_t& m = most[f.object];
    m = std::max(m, corners(f));
  }
  // Descending in corners, so their complements ascend.
  const auto place = [&](const Fill& f) { return std::array{~most.at(f.object), f.object, ~corners(f)}; };
  std::stable_sort(fills.fills.begin(), fills.fills.end(), [&](const Fill& a, const Fill& b) { return place(a) < place(b); });
}

}  // namespace hsr::internal
