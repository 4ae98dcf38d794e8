#include "hsr/surfaces/rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "geometry/ragged.h"
#include "hsr/scene/segment_filter.h"
#include "hsr/surfaces/fragment_observer.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A piece of a side between two neighbouring points.
struct Piece {
  MapLine line;
  bool reversed;
  std::uint32_t from, to, owner;
};

/// A closed way: pieces of it in corners_ from `begin` to `end`.
struct Loop {
  std::uint32_t begin, end;
  bool is_outer = false;
};

/// The lower bound of the x of a point, or of an end.
struct LowX {
  double low;
  std::uint32_t of;

  bool operator<(const LowX& o) const { return low != o.low ? low < o.low : of < o.of; }
};

void sort_by_x(std::vector<LowX>& order, const std::vector<MapPlace>& places) {
  order.resize(places.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) order[i] = {places[i].x - places[i].error_x, i};
  std::sort(order.begin(), order.end());
}

/// Loops that follow one another.
struct LoopRange {
  std::size_t begin, end;
};

}  // namespace

class RingLinker::Linker {
 public:
  Linker(MapPredicates& map, FragmentObserver* observer) : map_(map), observer_(observer) {}

  const Rings& link(std::span<const PlacedSide> sides) {
    clear();
    find_points(sides);
    cut_sides();
    const std::size_t cut = pieces_.size();
    cancel();
    if (observer_ != nullptr) observer_->cut_sides(cut, pieces_.size());
    link_pieces();
    walk();
    place_holes();
    make_result();
    return rings_;
  }

 private:
  void clear();
  void find_points(std::span<const PlacedSide> sides);
  void cut_sides();
  void cancel();
  void link_pieces();
  void link_at(std::span<const std::uint32_t> in, std::span<const std::uint32_t> out);
  void walk();
  void split(const std::vector<std::uint32_t>& pieces);
  void tell(const Loop& loop) const;
  void place_holes();
  bool is_before(std::uint32_t i, std::uint32_t j) const;
  bool begins_before(const Loop& a, const Loop& b) const;
  void make_result();
  std::span<const std::uint32_t> pieces_of(const Loop& loop) const {
    return {corners_.data() + loop.begin, corners_.data() + loop.end};
  }

  bool may_be_one(const MapPlace& p, const MapPlace& q) const {
    return std::fabs(p.x - q.x) <= p.error_x + q.error_x && std::fabs(p.y - q.y) <= p.error_y + q.error_y;
  }
  bool certainly_turn(std::uint32_t p, std::uint32_t q, std::uint32_t r) const;
  Sign turn(const Piece& p, bool back_p, const Piece& q, bool back_q);
  void add_corners(std::span<const std::uint32_t> way);
  bool turns_left(std::span<const std::uint32_t> pieces);
  bool contains(const Loop& outer, const Loop& hole);
  std::array<Rational, 2> exact(std::uint32_t point) const { return map_.exact_place(points_[point]); }
  Rational exact_area(std::span<const std::uint32_t> pieces) const;

  MapPredicates& map_;
  FragmentObserver* observer_;
  std::vector<const MapPoint*> end_points_;  // of both ends of each side
  std::vector<MapPlace> end_places_;
  DisjointSets owners_;  // those of one region
  DisjointSets same_;    // of these ends, those at one point
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> lowest_, number_;  // by the end that stands for a point: the end of the lowest symbol; the point
  std::vector<MapPoint> points_;
  std::vector<MapPlace> places_;
  std::vector<LowX> by_x_;                                        // points; before, the ends of sides
  double widest_ = 0;                                             // of the bounds of x
  std::vector<Piece> ends_, pieces_, kept_;                       // of whole sides; of cut ones; of these
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_ends_;  // pieces, by the points they join
  std::vector<std::uint32_t> inside_;                             // points of a side
  Ragged<std::uint32_t> arriving_, leaving_;                      // pieces by point
  std::vector<std::uint32_t> next_;                               // by piece
  std::vector<std::uint8_t> is_done_;                             // by piece
  std::vector<std::uint32_t> walk_, way_;                         // pieces
  std::vector<std::uint32_t> place_on_way_;  // of each point on the way of split(), the piece that leaves it
  std::vector<std::uint32_t> corners_;       // pieces, loop after loop
  std::vector<Loop> loops_;
  std::vector<LoopRange> walks_, regions_, holes_;
  std::vector<std::size_t> region_of_hole_;
  Rings rings_;
};

void RingLinker::Linker::clear() {
  end_points_.clear();
  end_places_.clear();
  points_.clear();
  places_.clear();
  ends_.clear();
  pieces_.clear();
  corners_.clear();
  loops_.clear();
  walks_.clear();
  regions_.clear();
  holes_.clear();
  region_of_hole_.clear();
  widest_ = 0;
  rings_.rings.clear();
  rings_.first_ring.assign(1, 0);
  rings_.owner_of_region.clear();
  rings_.region_owner.clear();
}

/// Whether three points certainly lie on no line.
bool RingLinker::Linker::certainly_turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const MapPlace &p = places_[i], &q = places_[j], &r = places_[k];
  const double error = std::max({p.error_x, p.error_y, q.error_x, q.error_y, r.error_x, r.error_y});
  return SegmentFilter({p.x, p.y}, {q.x, q.y}, error).turn({r.x, r.y}).is_certain();
}

/// Gives each point of the image one number.
void RingLinker::Linker::find_points(std::span<const PlacedSide> sides) {
  for (const PlacedSide& s : sides) {
    end_points_.push_back(&s.side.from);
    end_points_.push_back(&s.side.to);
    end_places_.push_back(s.from);
    end_places_.push_back(s.to);
  }
  std::uint32_t owners = 0;
  for (const PlacedSide& s : sides) owners = std::max(owners, s.owner + 1);
  owners_.reset(owners);
  const std::size_t n = end_points_.size();
  sort_by_x(by_x_, end_places_);
  same_.reset(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t end = by_x_[i].of;
    const MapPlace& p = end_places_[end];
    const double high = p.x + p.error_x;
    for (std::size_t j = i + 1; j < n && !(by_x_[j].low > high); ++j) {
      const std::uint32_t other = by_x_[j].of;
      if (may_be_one(p, end_places_[other]) && same_.find(end) != same_.find(other) &&
          map_.equal(*end_points_[end], *end_points_[other]))
        same_.join(end, other);
    }
  }
  // The lowest symbol stands for the point, and points are numbered by it.
  lowest_.assign(n, none);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t& lowest = lowest_[same_.find(i)];
    if (lowest == none || *end_points_[i] < *end_points_[lowest]) lowest = i;
  }
  order_.clear();
  for (const std::uint32_t i : lowest_)
    if (i != none) order_.push_back(i);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) { return *end_points_[i] < *end_points_[j]; });
  number_.resize(n);
  for (const std::uint32_t i : order_) {
    number_[same_.find(i)] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(*end_points_[i]);
    places_.push_back(end_places_[i]);
  }
  const auto number_of = [&](std::size_t end) { return number_[same_.find(static_cast<std::uint32_t>(end))]; };
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Piece piece{sides[k].side.line, sides[k].side.reversed, number_of(2 * k), number_of(2 * k + 1), sides[k].owner};
    if (piece.from != piece.to) ends_.push_back(piece);
  }
  sort_by_x(by_x_, places_);
  for (const MapPlace& p : places_) widest_ = std::max(widest_, 2 * p.error_x);
}

/// Cuts each side at the points inside it.
void RingLinker::Linker::cut_sides() {
  for (const Piece& side : ends_) {
    const MapPlace &p = places_[side.from], &q = places_[side.to];
    const double low = std::min(p.x - p.error_x, q.x - q.error_x), high = std::max(p.x + p.error_x, q.x + q.error_x);
    const double low_y = std::min(p.y - p.error_y, q.y - q.error_y), high_y = std::max(p.y + p.error_y, q.y + q.error_y);
    inside_.clear();
    const auto begin = std::isfinite(low) && std::isfinite(widest_)
                           ? std::lower_bound(by_x_.begin(), by_x_.end(), low - widest_,
                                              [](const LowX& point, double x) { return point.low < x; })
                           : by_x_.begin();
    // What is no number is not beyond.
    for (auto at = begin; at != by_x_.end() && !(at->low > high); ++at) {
      const std::uint32_t i = at->of;
      const MapPlace& r = places_[i];
      if (i == side.from || i == side.to || r.x + r.error_x < low || r.y + r.error_y < low_y || r.y - r.error_y > high_y)
        continue;
      if (certainly_turn(side.from, side.to, i)) continue;
      if (map_.side(side.line, points_[i]) != Sign::zero) continue;
      const Sign after_from = map_.order(side.line, points_[side.from], points_[i]);
      const Sign before_to = map_.order(side.line, points_[i], points_[side.to]);
      if (after_from == before_to && after_from != Sign::zero) inside_.push_back(i);
    }
    std::sort(inside_.begin(), inside_.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Sign s = map_.order(side.line, points_[i], points_[j]);
      return s == (side.reversed ? Sign::positive : Sign::negative);
    });
    std::uint32_t from = side.from;
    for (const std::uint32_t i : inside_) {
      pieces_.push_back({side.line, side.reversed, from, i, side.owner});
      from = i;
    }
    pieces_.push_back({side.line, side.reversed, from, side.to, side.owner});
  }
}

/// Pieces both ways between two points cancel; of several one way one is left.
void RingLinker::Linker::cancel() {
  by_ends_.clear();
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const auto [low, high] = std::minmax(pieces_[i].from, pieces_[i].to);
    by_ends_.push_back({std::uint64_t{low} << 32U | high, i});
  }
  std::sort(by_ends_.begin(), by_ends_.end());
  kept_.clear();
  for (std::size_t i = 0; i < by_ends_.size();) {
    const std::uint64_t ends = by_ends_[i].first;
    // Of those each way the first by name.
    int ways = 0;
    const Piece *up = nullptr, *down = nullptr;
    const std::uint32_t owner = pieces_[by_ends_[i].second].owner;
    for (; i < by_ends_.size() && by_ends_[i].first == ends; ++i) {
      const Piece& p = pieces_[by_ends_[i].second];
      owners_.join(owner, p.owner);
      const bool is_up = p.from < p.to;
      ways += is_up ? 1 : -1;
      const Piece*& first = is_up ? up : down;
      if (first == nullptr || std::tie(p.line, p.reversed) < std::tie(first->line, first->reversed)) first = &p;
    }
    if (ways != 0) kept_.push_back(ways > 0 ? *up : *down);
  }
  std::swap(pieces_, kept_);
}

/// How the ray along q turns against the ray along p; both may run backwards.
Sign RingLinker::Linker::turn(const Piece& p, bool back_p, const Piece& q, bool back_q) {
  const Sign s = map_.turn(p.line, q.line);
  return (p.reversed != back_p) == (q.reversed != back_q) ? s : -s;
}

/// At a point of several pieces each that arrives goes on with the one that bounds the same part of the inside: the next one
/// clockwise from where it came from.
void RingLinker::Linker::link_at(std::span<const std::uint32_t> in, std::span<const std::uint32_t> out) {
  if (in.size() != out.size()) throw InvariantError("link_rings: the sides do not close");
  if (in.empty()) return;
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

void RingLinker::Linker::link_pieces() {
  next_.assign(pieces_.size(), none);
  const auto sort = [&](Ragged<std::uint32_t>& sorted, std::uint32_t Piece::*point) {
    sorted.assign(points_.size(), [&](const auto& add) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) add(pieces_[i].*point, i);
    });
  };
  sort(arriving_, &Piece::to);
  sort(leaving_, &Piece::from);
  for (std::size_t p = 0; p < points_.size(); ++p) link_at(arriving_[p], leaving_[p]);
}

void RingLinker::Linker::walk() {
  is_done_.assign(pieces_.size(), 0);
  place_on_way_.assign(points_.size(), none);
  for (std::uint32_t first = 0; first < pieces_.size(); ++first) {
    if (is_done_[first] != 0) continue;
    walk_.clear();
    for (std::uint32_t i = first; is_done_[i] == 0; i = next_[i]) {
      is_done_[i] = 1;
      walk_.push_back(i);
    }
    split(walk_);
  }
}

/// Where the walk comes back to a point, what lies between is a loop of its own.
void RingLinker::Linker::split(const std::vector<std::uint32_t>& pieces) {
  const std::size_t first_loop = loops_.size();
  std::vector<std::uint32_t>& way = way_;
  way.clear();
  for (const std::uint32_t i : pieces) {
    place_on_way_[pieces_[i].from] = static_cast<std::uint32_t>(way.size());
    way.push_back(i);
    const std::uint32_t begin = place_on_way_[pieces_[i].to];
    if (begin == none) continue;
    for (std::size_t k = begin; k < way.size(); ++k) place_on_way_[pieces_[way[k]].from] = none;
    Loop loop{static_cast<std::uint32_t>(corners_.size()), 0};
    add_corners(std::span(way).subspan(begin));
    loop.end = static_cast<std::uint32_t>(corners_.size());
    loop.is_outer = turns_left(pieces_of(loop));
    if (observer_ != nullptr) tell(loop);
    loops_.push_back(loop);
    way.resize(begin);
  }
  if (!way.empty()) throw InvariantError("link_rings: a walk that does not close");
  walks_.push_back({first_loop, loops_.size()});
}

void RingLinker::Linker::tell(const Loop& loop) const {
  std::vector<MapCorner> corners;
  for (const std::uint32_t i : pieces_of(loop))
    corners.push_back({points_[pieces_[i].from], pieces_[i].line, pieces_[i].reversed});
  observer_->closed_ring(corners, loop.is_outer);
}

/// Of each straight run the first piece, which then stands for the run.
void RingLinker::Linker::add_corners(std::span<const std::uint32_t> way) {
  const std::size_t first = corners_.size();
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Piece &before = pieces_[way[k == 0 ? way.size() - 1 : k - 1]], &here = pieces_[way[k]];
    if (before.line == here.line) continue;
    if (!certainly_turn(before.from, here.from, here.to) && map_.turn(before.line, here.line) == Sign::zero) continue;
    corners_.push_back(way[k]);
  }
  if (corners_.size() < first + 3) throw InvariantError("link_rings: a ring without area");
}

Rational RingLinker::Linker::exact_area(std::span<const std::uint32_t> pieces) const {
  Rational twice;
  std::vector<std::array<Rational, 2>> at;
  for (const std::uint32_t i : pieces) at.push_back(exact(pieces_[i].from));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto &p = at[k], &q = at[(k + 1) % at.size()];
    twice = twice + (p[0] * q[1] - p[1] * q[0]);
  }
  return twice;
}

bool RingLinker::Linker::turns_left(std::span<const std::uint32_t> pieces) {
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
  const Sign s = twice.is_certain() ? sign_of(twice.value) : exact_area(pieces).sign();
  if (s == Sign::zero) throw InvariantError("link_rings: a ring without area");
  return s == Sign::positive;
}

/// Whether the middle of a side of the hole lies inside: it is on no other ring.
bool RingLinker::Linker::contains(const Loop& outer, const Loop& hole) {
  const Piece& side = pieces_[pieces_of(hole)[0]];
  const std::span<const std::uint32_t> border = pieces_of(outer);
  const auto p = exact(side.from), q = exact(side.to);
  const Rational half = 0.5, x = half * (p[0] + q[0]), y = half * (p[1] + q[1]);
  bool inside = false;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const auto a = exact(pieces_[border[k]].from), b = exact(pieces_[border[(k + 1) % border.size()]].from);
    if ((a[1] > y) == (b[1] > y)) continue;
    const Rational at = a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
    if (at > x) inside = !inside;
  }
  return inside;
}

void RingLinker::Linker::place_holes() {
  for (const LoopRange& walk : walks_) {
    const auto begin = loops_.begin() + static_cast<std::ptrdiff_t>(walk.begin),
               end = loops_.begin() + static_cast<std::ptrdiff_t>(walk.end);
    const auto outer = std::find_if(begin, end, [](const Loop& l) { return l.is_outer; });
    if (outer == end) {
      // The holes of one walk touch one another: one region has them all. The first is placed, the others follow.
      holes_.push_back(walk);
      continue;
    }
    std::iter_swap(begin, outer);
    if (std::count_if(begin, end, [](const Loop& l) { return l.is_outer; }) != 1)
      throw InvariantError("link_rings: a region with two outer rings");
    regions_.push_back(walk);
  }
  if (holes_.empty()) return;
  struct Box {
    double low_x = HUGE_VAL, high_x = -HUGE_VAL, low_y = HUGE_VAL, high_y = -HUGE_VAL;
  };
  // Outward: around the loop for certain; inward (-1): no larger than around it.
  const auto box = [&](const Loop& loop, double outward) {
    Box b;
    for (const std::uint32_t i : pieces_of(loop)) {
      const MapPlace& p = places_[pieces_[i].from];
      b.low_x = std::min(b.low_x, p.x - outward * p.error_x);
      b.high_x = std::max(b.high_x, p.x + outward * p.error_x);
      b.low_y = std::min(b.low_y, p.y - outward * p.error_y);
      b.high_y = std::max(b.high_y, p.y + outward * p.error_y);
    }
    return b;
  };
  const auto outer_of = [&](std::size_t region) -> const Loop& { return loops_[regions_[region].begin]; };
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < regions_.size(); ++r) boxes.push_back(box(outer_of(r), 1));
  for (const LoopRange& hole : holes_) {
    const Loop& first = loops_[hole.begin];
    const Box b = box(first, -1);
    std::vector<std::size_t> candidates;
    for (std::size_t r = 0; r < regions_.size(); ++r)
      if (boxes[r].low_x <= b.low_x && boxes[r].high_x >= b.high_x && boxes[r].low_y <= b.low_y && boxes[r].high_y >= b.high_y)
        candidates.push_back(r);
    if (candidates.size() != 1) {
      std::erase_if(candidates, [&](std::size_t r) { return !contains(outer_of(r), first); });
      // Outer rings around one hole lie inside one another: the smallest is the nearest.
      if (candidates.size() > 1)
        std::sort(candidates.begin(), candidates.end(), [&](std::size_t r, std::size_t s) {
          return exact_area(pieces_of(outer_of(r))) < exact_area(pieces_of(outer_of(s)));
        });
    }
    if (candidates.empty()) throw InvariantError("link_rings: a hole in no region");
    region_of_hole_.push_back(candidates[0]);
  }
}

/// Whether a point is to the left of another, or straight below it: by places, exactly where these do not tell.
bool RingLinker::Linker::is_before(std::uint32_t i, std::uint32_t j) const {
  const MapPlace &p = places_[i], &q = places_[j];
  if (i == j) return false;
  if (std::fabs(p.x - q.x) > p.error_x + q.error_x) return p.x < q.x;
  if (p.error_x + q.error_x == 0 && std::fabs(p.y - q.y) > p.error_y + q.error_y) return p.y < q.y;
  return exact(i) < exact(j);
}

/// Whether a ring begins before another, or they begin at one point and it goes on before.
bool RingLinker::Linker::begins_before(const Loop& a, const Loop& b) const {
  const auto p = pieces_of(a), q = pieces_of(b);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t i = pieces_[p[k]].from, j = pieces_[q[k]].from;
    if (i != j) return is_before(i, j);
  }
  return false;
}

/// Rings begin at their first point, and regions and their holes come in that order: how points are named makes no difference.
void RingLinker::Linker::make_result() {
  for (const Loop& loop : loops_) {
    const auto begin = corners_.begin() + loop.begin, end = corners_.begin() + loop.end;
    std::rotate(begin,
                std::min_element(begin, end,
                                 [&](std::uint32_t i, std::uint32_t j) { return is_before(pieces_[i].from, pieces_[j].from); }),
                end);
  }
  std::vector<std::vector<const Loop*>> rings(regions_.size());
  const auto add = [&](const LoopRange& range, std::vector<const Loop*>& to) {
    for (std::size_t k = range.begin; k < range.end; ++k) to.push_back(&loops_[k]);
  };
  for (std::size_t r = 0; r < regions_.size(); ++r) add(regions_[r], rings[r]);
  for (std::size_t h = 0; h < holes_.size(); ++h) add(holes_[h], rings[region_of_hole_[h]]);
  const auto is_first = [&](const Loop* a, const Loop* b) { return begins_before(*a, *b); };
  for (auto& of_region : rings) std::sort(of_region.begin() + 1, of_region.end(), is_first);
  std::sort(rings.begin(), rings.end(), [&](const auto& a, const auto& b) { return is_first(a.front(), b.front()); });
  // What bounds a region from several sides is one polygon, or several that were joined across a side, or by what lies between.
  for (const auto& of_region : rings) {
    rings_.owner_of_region.push_back(owners_.find(pieces_[pieces_of(*of_region.front()).front()].owner));
    for (const Loop* loop : of_region) {
      for (const std::uint32_t i : pieces_of(*loop))
        rings_.rings.push_back({points_[pieces_[i].from], pieces_[i].line, pieces_[i].reversed});
      rings_.rings.end_row();
    }
    rings_.first_ring.push_back(static_cast<std::uint32_t>(rings_.rings.size()));
  }
  for (std::uint32_t k = 0; k < owners_.size(); ++k) rings_.region_owner.push_back(owners_.find(k));
}

RingLinker::RingLinker(MapPredicates& map, FragmentObserver* observer) : linker_(std::make_unique<Linker>(map, observer)) {}
RingLinker::~RingLinker() = default;

const Rings& RingLinker::link(std::span<const PlacedSide> sides) { return linker_->link(sides); }

Rings link_rings(MapPredicates& map, std::span<const MapSide> sides, std::span<const std::uint32_t> owners) {
  std::vector<PlacedSide> placed;
  placed.reserve(sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k)
    placed.push_back({sides[k], map.place(sides[k].from), map.place(sides[k].to), owners.empty() ? 0 : owners[k]});
  return RingLinker(map).link(placed);
}

}  // namespace hsr::internal
