#include "hsr/surfaces/rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"

namespace hsr {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A piece of a side between two neighbouring points.
struct Piece {
  MapLine line;
  bool reversed;
  std::uint32_t from, to;
};

struct Loop {
  std::vector<std::uint32_t> pieces;
  bool is_outer = false;
};

/// The loops of one closed walk along the border of a connected region.
struct Walk {
  std::vector<Loop> loops;
};

class Linker {
 public:
  Linker(MapSight& map, std::span<const MapSide> sides) : map_(map), sides_(sides) {}

  Rings rings() {
    find_points();
    cut_sides();
    cancel();
    link();
    walk();
    place_holes();
    return result();
  }

 private:
  void find_points();
  void cut_sides();
  void cancel();
  void link();
  void link_at(std::vector<std::uint32_t>& in, std::vector<std::uint32_t>& out);
  void walk();
  void split(const std::vector<std::uint32_t>& pieces);
  void place_holes();
  Rings result() const;

  bool may_be_one(const MapPlace& p, const MapPlace& q) const {
    return std::fabs(p.x - q.x) <= p.error_x + q.error_x && std::fabs(p.y - q.y) <= p.error_y + q.error_y;
  }
  bool certainly_turn(std::uint32_t p, std::uint32_t q, std::uint32_t r) const;
  Sign turn(const Piece& p, bool back_p, const Piece& q, bool back_q);
  void drop_straight(std::vector<std::uint32_t>& pieces);
  bool turns_left(const std::vector<std::uint32_t>& pieces);
  bool contains(const Loop& outer, const Loop& hole);
  std::array<Rational, 2> exact(std::uint32_t point) const { return map_.exact_place(points_[point]); }
  Rational exact_area(const Loop& loop) const;

  MapSight& map_;
  std::span<const MapSide> sides_;
  std::vector<MapPoint> points_;
  std::vector<MapPlace> places_;
  std::vector<std::uint32_t> by_x_;          // points, by the lower bound of x
  double widest_ = 0;                        // of the bounds of x
  std::vector<Piece> ends_, pieces_;         // of whole sides; of cut ones
  std::vector<std::uint32_t> next_;          // by piece
  std::vector<std::uint32_t> place_on_way_;  // of each point on the way of split(), the piece that leaves it
  std::vector<Walk> walks_;
  std::vector<std::vector<Loop>> regions_;
  std::vector<std::size_t> holes_of_walk_;
};

/// Whether three points certainly lie on no line: the bound of ImageLine, E the largest error of the three.
bool Linker::certainly_turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const MapPlace &p = places_[i], &q = places_[j], &r = places_[k];
  const double error = std::max({p.error_x, p.error_y, q.error_x, q.error_y, r.error_x, r.error_y});
  const double dx = q.x - p.x, dy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
  const double d = std::fabs(dx) + std::fabs(dy), l = std::fabs(rx) + std::fabs(ry);
  return std::fabs(dx * ry - dy * rx) > 2.2 * error * (d + l) + 9.1 * error * error + 4.2 * ErrorBounded::u * d * l + 0x1p-1000;
}

/// Gives each point of the image one number.
void Linker::find_points() {
  std::vector<MapPoint> all;
  all.reserve(2 * sides_.size());
  for (const MapSide& s : sides_) {
    all.push_back(s.from);
    all.push_back(s.to);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<MapPlace> places;
  places.reserve(all.size());
  for (const MapPoint& p : all) places.push_back(map_.place(p));
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double x = places[i].x - places[i].error_x, y = places[j].x - places[j].error_x;
    return x != y ? x < y : i < j;
  });
  DisjointSets same(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const MapPlace& p = places[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const MapPlace& q = places[order[j]];
      if (q.x - q.error_x > p.x + p.error_x) break;
      if (may_be_one(p, q) && same.find(order[i]) != same.find(order[j]) && map_.equal(all[order[i]], all[order[j]]))
        same.join(order[i], order[j]);
    }
  }
  // The lowest symbol stands for the point.
  std::vector<std::uint32_t> number(all.size(), none);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const auto root = static_cast<std::uint32_t>(same.find(i));
    if (number[root] == none) {
      number[root] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(all[i]);
      places_.push_back(places[i]);
    }
    number[i] = number[root];
  }
  const auto number_of = [&](const MapPoint& p) {
    return number[static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), p) - all.begin())];
  };
  for (const MapSide& s : sides_) {
    const Piece piece{s.line, s.reversed, number_of(s.from), number_of(s.to)};
    if (piece.from != piece.to) ends_.push_back(piece);
  }
  by_x_.resize(points_.size());
  std::iota(by_x_.begin(), by_x_.end(), 0U);
  std::sort(by_x_.begin(), by_x_.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double x = places_[i].x - places_[i].error_x, y = places_[j].x - places_[j].error_x;
    return x != y ? x < y : i < j;
  });
  for (const MapPlace& p : places_) widest_ = std::max(widest_, 2 * p.error_x);
}

/// Cuts each side at the points inside it.
void Linker::cut_sides() {
  std::vector<std::uint32_t> inside;
  for (const Piece& side : ends_) {
    const MapPlace &p = places_[side.from], &q = places_[side.to];
    const double low = std::min(p.x - p.error_x, q.x - q.error_x), high = std::max(p.x + p.error_x, q.x + q.error_x);
    const double low_y = std::min(p.y - p.error_y, q.y - q.error_y), high_y = std::max(p.y + p.error_y, q.y + q.error_y);
    inside.clear();
    const auto begin = std::isfinite(low) && std::isfinite(widest_)
                           ? std::lower_bound(by_x_.begin(), by_x_.end(), low - widest_,
                                              [&](std::uint32_t i, double x) { return places_[i].x - places_[i].error_x < x; })
                           : by_x_.begin();
    for (auto i = begin; i != by_x_.end(); ++i) {
      const MapPlace& r = places_[*i];
      if (r.x - r.error_x > high) break;
      if (*i == side.from || *i == side.to || r.x + r.error_x < low || r.y + r.error_y < low_y || r.y - r.error_y > high_y)
        continue;
      if (certainly_turn(side.from, side.to, *i)) continue;
      if (map_.side(side.line, points_[*i]) != Sign::zero) continue;
      const Sign after_from = map_.order(side.line, points_[side.from], points_[*i]);
      const Sign before_to = map_.order(side.line, points_[*i], points_[side.to]);
      if (after_from == before_to && after_from != Sign::zero) inside.push_back(*i);
    }
    std::sort(inside.begin(), inside.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Sign s = map_.order(side.line, points_[i], points_[j]);
      return s == (side.reversed ? Sign::positive : Sign::negative);
    });
    std::uint32_t from = side.from;
    for (const std::uint32_t i : inside) {
      pieces_.push_back({side.line, side.reversed, from, i});
      from = i;
    }
    pieces_.push_back({side.line, side.reversed, from, side.to});
  }
}

/// Pieces both ways between two points cancel; of several one way one is left.
void Linker::cancel() {
  const auto key = [](const Piece& p) { return std::pair(std::min(p.from, p.to), std::max(p.from, p.to)); };
  std::sort(pieces_.begin(), pieces_.end(), [&](const Piece& p, const Piece& q) {
    return std::tuple(key(p), p.from, p.line, p.reversed) < std::tuple(key(q), q.from, q.line, q.reversed);
  });
  std::vector<Piece> kept;
  for (std::size_t i = 0; i < pieces_.size();) {
    std::size_t end = i;
    int ways = 0;
    std::size_t other = i;  // the first that runs from the higher point
    for (; end < pieces_.size() && key(pieces_[end]) == key(pieces_[i]); ++end) {
      const bool up = pieces_[end].from < pieces_[end].to;
      ways += up ? 1 : -1;
      if (up) other = end + 1;
    }
    if (ways > 0) kept.push_back(pieces_[i]);
    if (ways < 0) kept.push_back(pieces_[other]);
    i = end;
  }
  pieces_ = std::move(kept);
}

/// How the ray along q turns against the ray along p; both may run backwards.
Sign Linker::turn(const Piece& p, bool back_p, const Piece& q, bool back_q) {
  const Sign s = map_.turn(p.line, q.line);
  return (p.reversed != back_p) == (q.reversed != back_q) ? s : -s;
}

/// At a point of several pieces each that arrives goes on with the one that bounds the same part of the inside: the next one
/// clockwise from where it came from.
void Linker::link_at(std::vector<std::uint32_t>& in, std::vector<std::uint32_t>& out) {
  if (in.size() != out.size()) throw InvariantError("link_rings: the sides do not close");
  if (in.size() == 1) {
    next_[in[0]] = out[0];
    return;
  }
  struct Ray {
    std::uint32_t piece;
    bool arrives;
  };
  std::vector<Ray> rays;
  rays.reserve(in.size() + out.size());
  for (const std::uint32_t i : in) rays.push_back({i, true});
  for (const std::uint32_t i : out) rays.push_back({i, false});
  const Ray base = rays[0];
  // 0: along the base; 1: to its left; 2: opposite; 3: to its right.
  const auto part = [&](const Ray& r) {
    const Sign s = turn(pieces_[base.piece], base.arrives, pieces_[r.piece], r.arrives);
    if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
    const Piece &p = pieces_[base.piece], &q = pieces_[r.piece];
    const bool same =
        (map_.same_way(p.line, q.line) == Sign::positive) == ((p.reversed != base.arrives) == (q.reversed != r.arrives));
    return same ? 0 : 2;
  };
  std::vector<int> parts;
  parts.reserve(rays.size());
  std::vector<std::size_t> order(rays.size());
  for (const Ray& r : rays) parts.push_back(part(r));
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Counter-clockwise.
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (parts[i] != parts[j]) return parts[i] < parts[j];
    return turn(pieces_[rays[i].piece], rays[i].arrives, pieces_[rays[j].piece], rays[j].arrives) == Sign::positive;
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Ray& r = rays[order[k]];
    if (!r.arrives) continue;
    const Ray& clockwise = rays[order[(k + order.size() - 1) % order.size()]];
    if (clockwise.arrives) throw InvariantError("link_rings: the inside is not to the left of all sides at a point");
    next_[r.piece] = clockwise.piece;
  }
}

void Linker::link() {
  next_.assign(pieces_.size(), none);
  std::vector<std::uint32_t> in(pieces_.size()), out(pieces_.size());
  std::iota(in.begin(), in.end(), 0U);
  std::iota(out.begin(), out.end(), 0U);
  std::sort(in.begin(), in.end(), [&](auto i, auto j) { return std::pair(pieces_[i].to, i) < std::pair(pieces_[j].to, j); });
  std::sort(out.begin(), out.end(),
            [&](auto i, auto j) { return std::pair(pieces_[i].from, i) < std::pair(pieces_[j].from, j); });
  std::vector<std::uint32_t> arriving, leaving;
  std::size_t i = 0, j = 0;
  while (i < in.size() || j < out.size()) {
    const std::uint32_t point =
        std::min(i < in.size() ? pieces_[in[i]].to : none, j < out.size() ? pieces_[out[j]].from : none);
    arriving.clear();
    leaving.clear();
    for (; i < in.size() && pieces_[in[i]].to == point; ++i) arriving.push_back(in[i]);
    for (; j < out.size() && pieces_[out[j]].from == point; ++j) leaving.push_back(out[j]);
    link_at(arriving, leaving);
  }
}

void Linker::walk() {
  std::vector<bool> is_done(pieces_.size(), false);
  place_on_way_.assign(points_.size(), none);
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t first = 0; first < pieces_.size(); ++first) {
    if (is_done[first]) continue;
    pieces.clear();
    for (std::uint32_t i = first; !is_done[i]; i = next_[i]) {
      is_done[i] = true;
      pieces.push_back(i);
    }
    split(pieces);
  }
}

/// Where the walk comes back to a point, what lies between is a loop of its own.
void Linker::split(const std::vector<std::uint32_t>& pieces) {
  Walk walk;
  std::vector<std::uint32_t> way;
  for (const std::uint32_t i : pieces) {
    place_on_way_[pieces_[i].from] = static_cast<std::uint32_t>(way.size());
    way.push_back(i);
    const std::uint32_t begin = place_on_way_[pieces_[i].to];
    if (begin == none) continue;
    Loop loop{{way.begin() + begin, way.end()}};
    for (const std::uint32_t k : loop.pieces) place_on_way_[pieces_[k].from] = none;
    way.resize(begin);
    drop_straight(loop.pieces);
    loop.is_outer = turns_left(loop.pieces);
    walk.loops.push_back(std::move(loop));
  }
  if (!way.empty()) throw InvariantError("link_rings: a walk that does not close");
  walks_.push_back(std::move(walk));
}

/// Leaves of each straight run the first piece, which then stands for the run.
void Linker::drop_straight(std::vector<std::uint32_t>& pieces) {
  std::vector<std::uint32_t> corners;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece &before = pieces_[pieces[(k + pieces.size() - 1) % pieces.size()]], &here = pieces_[pieces[k]];
    if (before.line == here.line) continue;
    if (!certainly_turn(before.from, here.from, here.to) && map_.turn(before.line, here.line) == Sign::zero) continue;
    corners.push_back(pieces[k]);
  }
  if (corners.size() < 3) throw InvariantError("link_rings: a ring without area");
  pieces = std::move(corners);
}

Rational Linker::exact_area(const Loop& loop) const {
  Rational twice;
  std::vector<std::array<Rational, 2>> at;
  for (const std::uint32_t i : loop.pieces) at.push_back(exact(pieces_[i].from));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto &p = at[k], &q = at[(k + 1) % at.size()];
    twice = twice + (p[0] * q[1] - p[1] * q[0]);
  }
  return map_.mirrored() ? -twice : twice;
}

bool Linker::turns_left(const std::vector<std::uint32_t>& pieces) {
  const MapPlace& o = places_[pieces_[pieces[0]].from];
  ErrorBounded twice;
  const auto relative = [&](std::uint32_t i) {
    const MapPlace& p = places_[pieces_[i].from];
    return std::array{ErrorBounded{p.x, p.error_x} - ErrorBounded{o.x, o.error_x},
                      ErrorBounded{p.y, p.error_y} - ErrorBounded{o.y, o.error_y}};
  };
  for (std::size_t k = 1; k + 1 < pieces.size(); ++k) {
    const auto p = relative(pieces[k]), q = relative(pieces[k + 1]);
    twice = twice + (p[0] * q[1] - p[1] * q[0]);
  }
  const Sign s = twice.is_certain() ? sign_of(map_.mirrored() ? -twice.value : twice.value) : exact_area({pieces}).sign();
  if (s == Sign::zero) throw InvariantError("link_rings: a ring without area");
  return s == Sign::positive;
}

/// Whether the middle of a side of the hole lies inside: it is on no other ring.
bool Linker::contains(const Loop& outer, const Loop& hole) {
  const Piece& side = pieces_[hole.pieces[0]];
  const auto p = exact(side.from), q = exact(side.to);
  const Rational half = 0.5, x = half * (p[0] + q[0]), y = half * (p[1] + q[1]);
  bool inside = false;
  for (std::size_t k = 0; k < outer.pieces.size(); ++k) {
    const auto a = exact(pieces_[outer.pieces[k]].from), b = exact(pieces_[outer.pieces[(k + 1) % outer.pieces.size()]].from);
    if ((a[1] > y) == (b[1] > y)) continue;
    const Rational at = a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
    if (at > x) inside = !inside;
  }
  return inside;
}

void Linker::place_holes() {
  struct Box {
    double low_x = HUGE_VAL, high_x = -HUGE_VAL, low_y = HUGE_VAL, high_y = -HUGE_VAL;
  };
  // Outward: around the loop for certain; inward (-1): no larger than around it.
  const auto box = [&](const Loop& loop, double outward) {
    Box b;
    for (const std::uint32_t i : loop.pieces) {
      const MapPlace& p = places_[pieces_[i].from];
      b.low_x = std::min(b.low_x, p.x - outward * p.error_x);
      b.high_x = std::max(b.high_x, p.x + outward * p.error_x);
      b.low_y = std::min(b.low_y, p.y - outward * p.error_y);
      b.high_y = std::max(b.high_y, p.y + outward * p.error_y);
    }
    return b;
  };
  std::vector<Loop> holes;
  std::vector<Box> boxes;
  for (Walk& walk : walks_) {
    const auto outer = std::find_if(walk.loops.begin(), walk.loops.end(), [](const Loop& l) { return l.is_outer; });
    if (outer == walk.loops.end()) {
      std::move(walk.loops.begin(), walk.loops.end(), std::back_inserter(holes));
      // The holes of one walk touch one another: one region has them all. The first is placed, the others follow.
      holes_of_walk_.push_back(walk.loops.size());
      continue;
    }
    std::iter_swap(walk.loops.begin(), outer);
    if (std::count_if(walk.loops.begin(), walk.loops.end(), [](const Loop& l) { return l.is_outer; }) != 1)
      throw InvariantError("link_rings: a region with two outer rings");
    boxes.push_back(box(walk.loops[0], 1));
    regions_.push_back(std::move(walk.loops));
  }
  std::size_t first = 0;
  for (const std::size_t count : holes_of_walk_) {
    const Box b = box(holes[first], -1);
    std::vector<std::size_t> candidates;
    for (std::size_t r = 0; r < regions_.size(); ++r)
      if (boxes[r].low_x <= b.low_x && boxes[r].high_x >= b.high_x && boxes[r].low_y <= b.low_y && boxes[r].high_y >= b.high_y)
        candidates.push_back(r);
    if (candidates.size() != 1) {
      std::erase_if(candidates, [&](std::size_t r) { return !contains(regions_[r][0], holes[first]); });
      // Outer rings around one hole lie inside one another: the smallest is the nearest.
      if (candidates.size() > 1)
        std::sort(candidates.begin(), candidates.end(),
                  [&](std::size_t r, std::size_t s) { return exact_area(regions_[r][0]) < exact_area(regions_[s][0]); });
    }
    if (candidates.empty()) throw InvariantError("link_rings: a hole in no region");
    for (std::size_t k = 0; k < count; ++k) regions_[candidates[0]].push_back(std::move(holes[first + k]));
    first += count;
  }
}

Rings Linker::result() const {
  Rings rings;
  for (const auto& region : regions_) {
    for (const Loop& loop : region) {
      for (const std::uint32_t i : loop.pieces)
        rings.corners.push_back({points_[pieces_[i].from], pieces_[i].line, pieces_[i].reversed});
      rings.first_corner.push_back(static_cast<std::uint32_t>(rings.corners.size()));
    }
    rings.first_ring.push_back(static_cast<std::uint32_t>(rings.first_corner.size() - 1));
  }
  return rings;
}

}  // namespace

Rings link_rings(MapSight& map, std::span<const MapSide> sides) { return Linker(map, sides).rings(); }

}  // namespace hsr
