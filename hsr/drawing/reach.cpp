#include "hsr/drawing/reach.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/index.h"
#include "geometry/parallel.h"
#include "hsr/drawing/paper_polygons.h"
#include "hsr/drawing/paper_sides.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

std::vector<PaperSide> sides_of(const Fills& fills) {
  std::vector<PaperSide> sides;
  sides.reserve(fills.rings.values().size());
  for (std::uint32_t i = 0; i < fills.fills.size(); ++i)
    for (std::uint32_t r = fills.fills[i].first_ring; r < fills.fills[i].end_ring; ++r)
      append_sides(fills.rings[r], i, sides, r);
  return sides;
}

/// Where two fills meet along a side: the one that is painted first reaches beneath this side of the other.
struct AlongSide {
  std::uint32_t earlier = 0, side = 0;  // a fill, and a side of the later one
  friend constexpr auto operator<=>(const AlongSide&, const AlongSide&) = default;
};

/// Around the start of this side, within its polygon, an earlier fill reaches beneath it: the first of all that are painted there.
struct AtCorner {
  std::uint32_t earlier = 0, side = 0;
  friend constexpr auto operator<=>(const AtCorner&, const AtCorner&) = default;
};

/// Who reaches beneath whom.
class Neighbours {
 public:
  Neighbours(const Fills& fills, const PaperPolygons& polygons)
      : fills_(fills), polygons_(polygons), first_at_(polygons.sides().size(), none) {
    find_along_sides();
    find_at_corners();
    std::sort(along_sides.begin(), along_sides.end());
    std::sort(at_corners.begin(), at_corners.end());
  }

  std::vector<AlongSide> along_sides;
  std::vector<AtCorner> at_corners;
  /// The first fill that is painted at the start of a side, of those that meet there; none: it is alone.
  std::uint32_t first_at(std::uint32_t side) const { return first_at_[side]; }

 private:
  /// Or so nearly that what lies beneath adds less than can be seen.
  bool is_opaque(std::uint32_t fill) const { return fills_.fills[fill].opacity >= 0.99; }
  /// The later one covers it: it is opaque, or part of the same sheet, which is painted opaque.
  bool may_reach(std::uint32_t earlier, std::uint32_t later) const {
    const Fill &a = fills_.fills[earlier], &b = fills_.fills[later];
    return earlier < later && (is_opaque(later) || (a.layer == b.layer && a.opacity == b.opacity));
  }
  std::uint32_t owner(std::uint32_t side) const { return polygons_.sides()[side].owner; }
  std::uint32_t layer(std::uint32_t side) const { return fills_.fills[owner(side)].layer; }

  void find_along_sides() {
    // Sides ascend with their owners, so those painted first come first.
    const std::vector<SideKey> keys = sorted_keys(polygons_.sides());
    std::array<std::vector<std::uint32_t>, 2> beside;
    for (std::size_t i = 0; i < keys.size();) {
      beside[0].clear();
      beside[1].clear();
      const SideKey at = keys[i];
      // On either side, what an opaque one covers that is painted later needs nothing: the last opaque one, and those after it.
      for (; i < keys.size() && keys[i].is_at(at); ++i) {
        std::vector<std::uint32_t>& on = beside[keys[i].is_reversed ? 1 : 0];
        if (is_opaque(owner(keys[i].side))) on.clear();
        on.push_back(keys[i].side);
      }
      meet(beside[0], beside[1]);
    }
  }

  /// Layers ascend, as they are painted one after the other; fills of two sheets meet where these are of one layer.
  void meet(const std::vector<std::uint32_t>& some, const std::vector<std::uint32_t>& others) {
    if (some.empty() || others.empty()) return;
    for (const std::uint32_t p : some) {
      for (auto q = std::lower_bound(others.begin(), others.end(), layer(p),
                                     [&](std::uint32_t side, std::uint32_t value) { return layer(side) < value; });
           q != others.end() && layer(*q) == layer(p); ++q)
        meet(p, *q);
      if (layer(others.front()) != layer(p)) meet(p, others.front());
    }
    for (const std::uint32_t q : others)
      if (layer(some.front()) != layer(q) && q != others.front()) meet(some.front(), q);
  }
  void meet(std::uint32_t p, std::uint32_t q) {
    if (owner(p) == owner(q)) return;
    // Both ends: the start of one side is the end of the other.
    meetings_.push_back({polygons_.sides()[p].from, p, polygons_.after(q)});
    meetings_.push_back({polygons_.sides()[q].from, q, polygons_.after(p)});
    if (may_reach(owner(p), owner(q))) along_sides.push_back({owner(p), q});
    if (may_reach(owner(q), owner(p))) along_sides.push_back({owner(q), p});
  }

  /// Of the fills around a corner, one side after the other, the earliest; not of those that are only seen there by chance.
  void find_at_corners() {
    tbb::parallel_sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
      return std::tie(a.at, a.one, a.other) < std::tie(b.at, b.one, b.other);
    });
    std::vector<std::uint32_t> around;  // sides that start here
    DisjointSets together;
    const auto place = [&](std::uint32_t side) {
      return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), side) - around.begin());
    };
    for (std::size_t i = 0, end = 0; i < meetings_.size(); i = end) {
      around.clear();
      for (; end < meetings_.size() && meetings_[end].at == meetings_[i].at; ++end)
        around.insert(around.end(), {meetings_[end].one, meetings_[end].other});
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      together.reset(around.size());
      for (std::size_t k = i; k < end; ++k) together.join(place(meetings_[k].one), place(meetings_[k].other));
      for (std::uint32_t k = 0; k < around.size(); ++k) {
        const std::uint32_t first = owner(around[together.find(k)]);
        // Between two fills what reaches beneath both sides of a corner covers all of it, unless it is wide.
        if (around.size() < 3 && !polygons_.is_wide(around[k])) continue;
        first_at_[around[k]] = first;
        if (may_reach(first, owner(around[k]))) at_corners.push_back({first, around[k]});
      }
    }
  }

  /// Two sides of different fills that start at one point, the one to and the other fro along a side that they share.
  struct Meeting {
    PaperPoint at;
    std::uint32_t one = 0, other = 0;
  };

  const Fills& fills_;
  const PaperPolygons& polygons_;
  std::vector<Meeting> meetings_;
  std::vector<std::uint32_t> first_at_;
};

/// What fills become.
class Reaching {
 public:
  Reaching(const Fills& fills, const PaperPolygons& polygons)
      : fills_(fills), polygons_(polygons), neighbours_(fills, polygons) {
    find_rooms();
  }

  /// The rings of a fill with what it reaches beneath; nothing: as they were.
  std::vector<std::vector<PaperPoint>> rings(std::uint32_t fill) const {
    std::vector<std::uint32_t> wholly;
    const auto along = of_fill(neighbours_.along_sides, fill);
    const auto corners = of_fill(neighbours_.at_corners, fill);
    for (const AlongSide& a : along)
      if (takes_wholly(fill, a.side, a.side)) wholly.push_back(owner(a.side));
    for (const AtCorner& c : corners)
      if (takes_wholly(fill, c.side, polygons_.before(c.side))) wholly.push_back(owner(c.side));
    std::sort(wholly.begin(), wholly.end());
    wholly.erase(std::unique(wholly.begin(), wholly.end()), wholly.end());
    const auto is_taken = [&](std::uint32_t side) { return std::binary_search(wholly.begin(), wholly.end(), owner(side)); };

    std::vector<PaperSide> all;
    const auto add_polygon = [&](std::uint32_t of) {
      const auto sides = polygons_.sides_of(of);
      all.insert(all.end(), sides.begin(), sides.end());
    };
    for (const std::uint32_t later : wholly) add_polygon(later);
    for (const AlongSide& a : along)
      if (!is_taken(a.side)) append_sides(beneath_side(fill, a.side), fill, all);
    for (const AtCorner& c : corners)
      if (!is_taken(c.side)) append_sides(beneath_corner(fill, c.side), fill, all);
    if (all.empty()) return {};
    add_polygon(fill);
    return united_rings(all);
  }

 private:
  template <class T>
  static std::span<const T> of_fill(const std::vector<T>& all, std::uint32_t fill) {
    const auto begin = std::lower_bound(all.begin(), all.end(), T{fill, 0}),
               end = std::lower_bound(begin, all.end(), T{fill + 1, 0});
    return {begin, end};
  }
  std::uint32_t owner(std::uint32_t side) const { return polygons_.sides()[side].owner; }

  /// What is of nearly the same colour cannot show through at the other sides of the later one; what is less than a millimetre thick
  /// a viewer may see in one pixel with what is beside it.
  bool takes_wholly(std::uint32_t fill, std::uint32_t side, std::uint32_t other_side) const {
    constexpr int similar = 24;
    constexpr double thin = 1000;
    const std::uint32_t later = owner(side);
    if (!polygons_.has_few_sides(later)) return false;
    int difference = 0;
    for (std::size_t k = 0; k < 3; ++k)
      difference = std::max(difference, std::abs(fills_.fills[fill].colour[k] - fills_.fills[later].colour[k]));
    return difference <= similar || polygons_.height(side) <= thin || polygons_.height(other_side) <= thin;
  }

  /// The same for all sides that start at one point, so that what is reached beneath around it is one piece.
  void find_rooms() {
    room_.assign(polygons_.sides().size(), 0);
    std::vector<std::pair<PaperPoint, double>> rooms(neighbours_.at_corners.size());
    parallel_for_each(rooms.size(), [&](std::size_t k) {
      const std::uint32_t side = neighbours_.at_corners[k].side;
      rooms[k] = {polygons_.sides()[side].from, polygons_.room(side)};
    });
    tbb::parallel_sort(rooms.begin(), rooms.end());
    for (const AtCorner& c : neighbours_.at_corners)
      room_[c.side] = std::lower_bound(rooms.begin(), rooms.end(), std::pair(polygons_.sides()[c.side].from, 0.0))->second;
  }
  bool is_first_at(std::uint32_t fill, std::uint32_t side) const {
    return neighbours_.first_at(side) == fill && room_[side] >= 1;
  }

  std::vector<PaperPoint> beneath_side(std::uint32_t fill, std::uint32_t side) const {
    const PaperSide& s = polygons_.sides()[side];
    std::vector<PaperPoint> ring = {s.from, s.to};
    const std::uint32_t after = polygons_.after(side);
    if (is_first_at(fill, after)) {
      ring.push_back(polygons_.from_start(after, room_[after]));
      if (polygons_.is_wide(after)) ring.push_back(polygons_.inward(after, room_[after]));
    }
    std::vector<PaperPoint> top = polygons_.tent(side);
    ring.insert(ring.end(), top.rbegin(), top.rend());
    if (is_first_at(fill, side)) {
      if (polygons_.is_wide(side)) ring.push_back(polygons_.inward(side, room_[side]));
      ring.push_back(polygons_.from_end(polygons_.before(side), room_[side]));
    }
    return ring;
  }

  /// Nothing where the fill reaches beneath a side that starts or ends there.
  std::vector<PaperPoint> beneath_corner(std::uint32_t fill, std::uint32_t side) const {
    const auto reaches = [&](std::uint32_t beneath) {
      return std::binary_search(neighbours_.along_sides.begin(), neighbours_.along_sides.end(), AlongSide{fill, beneath});
    };
    const std::uint32_t before = polygons_.before(side);
    if (room_[side] < 1 || reaches(side) || reaches(before)) return {};
    std::vector<PaperPoint> ring = {polygons_.sides()[side].from, polygons_.from_start(side, room_[side])};
    if (polygons_.is_wide(side)) ring.push_back(polygons_.inward(side, room_[side]));
    ring.push_back(polygons_.from_end(before, room_[side]));
    return ring;
  }

  const Fills& fills_;
  const PaperPolygons& polygons_;
  Neighbours neighbours_;
  std::vector<double> room_;  // by side that starts at a corner where some fill reaches beneath others
};

}  // namespace

void reach_beneath(Fills& fills) {
  const PaperPolygons polygons(conforming(sides_of(fills)));
  const Reaching reaching(fills, polygons);
  std::vector<std::vector<std::vector<PaperPoint>>> united(fills.fills.size());
  parallel_for_each(united.size(), [&](std::size_t i) { united[i] = reaching.rings(static_cast<std::uint32_t>(i)); });
  Fills out;
  out.faces = std::move(fills.faces);
  out.lines = std::move(fills.lines);
  out.line_points = std::move(fills.line_points);
  const auto append = [&](std::span<const PaperPoint> ring) {
    check_countable(out.rings.values().size() + ring.size(), "corners of fills");
    out.rings.push_row(ring);
  };
  for (std::size_t i = 0; i < united.size(); ++i) {
    Fill fill = fills.fills[i];
    const auto first = static_cast<std::uint32_t>(out.rings.size());
    if (united[i].empty())
      for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) append(fills.rings[r]);
    for (const auto& ring : united[i]) append(ring);
    fill.first_ring = first;
    fill.end_ring = static_cast<std::uint32_t>(out.rings.size());
    out.fills.push_back(fill);
  }
  fills = std::move(out);
}

}  // namespace hsr::internal
