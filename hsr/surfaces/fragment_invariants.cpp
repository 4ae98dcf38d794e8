#include "hsr/surfaces/fragment_invariants.h"

#include <algorithm>
#include <string>

#include "geometry/error.h"
#include "hsr/scene/box_tree.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

namespace {

using Place = std::array<Rational, 2>;

struct Side {
  MapSide side;
  std::uint32_t ring;
  Place middle;
};

Place middle(const Place& p, const Place& q) { return {(p[0] + q[0]) / Rational(2.0), (p[1] + q[1]) / Rational(2.0)}; }

enum class Where { inside, border, outside };

/// By the sides that a ray from p to the left crosses.
Where where(const Place& p, std::span<const std::vector<Place>> rings) {
  bool inside = false;
  for (const std::vector<Place>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const Sign turn = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])).sign();
      const auto within = [&](std::size_t k) { return std::min(a[k], b[k]) <= p[k] && p[k] <= std::max(a[k], b[k]); };
      if (turn == Sign::zero && within(0) && within(1)) return Where::border;
      if ((a[1] > p[1]) != (b[1] > p[1]) && (turn == Sign::positive) == (b[1] > a[1])) inside = !inside;
    }
  return inside ? Where::inside : Where::outside;
}

Rational twice_area(std::span<const Place> ring) {
  Rational twice;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place &p = ring[i], &q = ring[(i + 1) % ring.size()];
    twice = twice + (p[0] * q[1] - p[1] * q[0]);
  }
  return twice;
}

/// The area that triangles cover together. Between two neighbours of all x of corners and crossings it is the width times what
/// is covered in the middle.
Rational area_of_union(std::span<const std::array<Place, 3>> triangles) {
  std::vector<std::array<Place, 2>> sides;
  std::vector<Rational> xs;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [p, q] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({p, q});
      xs.push_back(p[0]);
    }
  const auto y_at = [](const std::array<Place, 2>& side, const Rational& x) {
    const auto& [p, q] = side;
    return p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
  };
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto& [p, q] = sides[i];
      const auto& [r, s] = sides[k];
      const Rational from = std::max(p[0], r[0]), to = std::min(q[0], s[0]);
      if (!(from < to)) continue;
      const Rational a = y_at(sides[i], from) - y_at(sides[k], from), b = y_at(sides[i], to) - y_at(sides[k], to);
      if (a.sign() * b.sign() == Sign::negative) xs.push_back(from + a / (a - b) * (to - from));
    }
  for (const auto& side : sides) xs.push_back(side[1][0]);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  Rational area;
  std::vector<std::array<Rational, 2>> covered;
  for (std::size_t k = 1; k < xs.size(); ++k) {
    const Rational x = (xs[k - 1] + xs[k]) / Rational(2.0);
    covered.clear();
    for (std::size_t t = 0; t < sides.size(); t += 3) {
      std::vector<Rational> ys;
      for (std::size_t i = t; i < t + 3; ++i)
        if (sides[i][0][0] < x && x < sides[i][1][0]) ys.push_back(y_at(sides[i], x));
      if (ys.size() == 2) covered.push_back({std::min(ys[0], ys[1]), std::max(ys[0], ys[1])});
    }
    if (covered.empty()) continue;
    std::sort(covered.begin(), covered.end());
    Rational length, reached = covered.front()[0];
    for (const auto& [from, to] : covered) {
      if (to > reached) length = length + (to - std::max(from, reached));
      reached = std::max(reached, to);
    }
    area = area + length * (xs[k] - xs[k - 1]);
  }
  return area;
}

class Invariants {
 public:
  Invariants(const ProjectedMesh& projected, const VisibleFragments& all) : map_(projected), all_(all) {}

  void check() {
    for (const Fragment& f : all_.fragments) check_rings(f);
    check_sides();
    check_middles();
    check_area();
  }

 private:
  /// Together they cover what the faces cover. Of few triangles: it takes their square. Near cuts have no corners to look up.
  void check_area() {
    const ProjectedMesh& projected = map_.projected();
    const auto& triangles = projected.mesh().triangles;
    if (triangles.size() > 12) return;
    std::vector<std::array<Place, 3>> seen;
    for (TriangleId t{0}; t.value < triangles.size(); t = TriangleId(t.value + 1U)) {
      if (!projected.reaches_beyond_near(t)) continue;
      if (projected.reaches_before_near(t)) return;
      const auto place = [&](std::size_t k) { return map_.exact_place(MapPoint::of_vertex(triangles[t][k])); };
      if (projected.facing(t) != Sign::zero) seen.push_back({place(0), place(1), place(2)});
    }
    Rational twice;
    for (const auto& rings : rings_)
      for (const auto& ring : rings) twice = twice + twice_area(ring);
    const Rational area = area_of_union(seen), found = twice / Rational(2.0);
    expect(area == found || area == -found, "they do not cover what the faces cover");
  }

  static void expect(bool holds, const char* what) {
    if (!holds) throw InvariantError(std::string("fragments: ") + what);
  }

  std::vector<Place> places(std::uint32_t r) const {
    std::vector<Place> at;
    for (const MapCorner& c : all_.rings[r]) at.push_back(map_.exact_place(c.at));
    return at;
  }

  void check_rings(const Fragment& f) {
    std::vector<std::vector<Place>>& rings = rings_.emplace_back();
    ImageBox box = ImageBox::nothing();
    for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r) {
      rings.push_back(places(r));
      const std::vector<Place>& ring = rings.back();
      const auto corners = all_.rings[r];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = (i + 1) % ring.size();
        const Place &p = ring[i], &q = ring[next];
        sides_.push_back({{corners[i].line, corners[i].reversed, corners[i].at, corners[next].at}, r, middle(p, q)});
        add(box, corners[i].at);
      }
      expect(twice_area(ring).sign() == (r == f.first_ring ? Sign::positive : Sign::negative), "a ring turns the wrong way");
      if (r != f.first_ring)
        expect(where(middle(ring[0], ring[1]), std::span(rings).first(1)) != Where::outside, "a hole is outside");
    }
    boxes_.push_back(box);
  }

  void add(ImageBox& box, const MapPoint& p) const {
    const MapPlace at = map_.place(p);
    box.add({at.x, at.y, 0}, {at.error_x, at.error_y, 0});
  }

  /// A border of one fragment inside another: they overlap.
  void check_middles() {
    const BoxTree tree(boxes_);
    for (const Side& s : sides_) {
      ImageBox box = ImageBox::nothing();
      add(box, s.side.from);
      add(box, s.side.to);
      tree.visit_touching(box, [&](std::uint32_t k) {
        expect(where(s.middle, rings_[k]) != Where::inside, "a side is inside another fragment");
        return true;
      });
    }
  }

  void check_sides() {
    std::vector<ImageBox> boxes;
    for (const Side& s : sides_) {
      boxes.push_back(ImageBox::nothing());
      add(boxes.back(), s.side.from);
      add(boxes.back(), s.side.to);
    }
    const BoxTree tree(boxes);
    BoxTree::PairSearch search;
    for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
      tree.visit_pairs(leaf, search, [&](std::uint32_t i, std::uint32_t k) { check_pair(sides_[i], sides_[k]); });
  }

  void check_pair(const Side& s, const Side& t) {
    const auto signs = [&](const Side& x, const Side& y) {
      return std::array{map_.side(x.side.line, y.side.from), map_.side(x.side.line, y.side.to)};
    };
    const auto of_t = signs(s, t), of_s = signs(t, s);
    if (of_t[0] == Sign::zero && of_t[1] == Sign::zero) {
      const bool same_way = (map_.same_way(s.side.line, t.side.line) == Sign::positive) == (s.side.reversed == t.side.reversed);
      expect(!same_way || !overlap(s.side, t.side), "two sides run along one another");
      return;
    }
    expect(of_t[0] * of_t[1] != Sign::negative || of_s[0] * of_s[1] != Sign::negative, "two sides cross");
    if (s.ring != t.ring) return;
    // Of one ring: they meet only where one begins and the other ends.
    const auto inside = [](const std::array<Sign, 2>& on, const std::array<Sign, 2>& across) {
      return (on[0] == Sign::zero || on[1] == Sign::zero) && across[0] * across[1] == Sign::negative;
    };
    expect(!inside(of_t, of_s) && !inside(of_s, of_t), "a ring touches itself");
  }

  /// Of two sides on one line: whether they have more than a point in common.
  bool overlap(const MapSide& s, const MapSide& t) {
    const auto ends = [&](const MapSide& x) {
      return map_.order(s.line, x.from, x.to) == Sign::negative ? std::array{x.from, x.to} : std::array{x.to, x.from};
    };
    const auto a = ends(s), b = ends(t);
    return map_.order(s.line, a[0], b[1]) == Sign::negative && map_.order(s.line, b[0], a[1]) == Sign::negative;
  }

  MapPredicates map_;
  const VisibleFragments& all_;
  std::vector<Side> sides_;
  std::vector<std::vector<std::vector<Place>>> rings_;  // of each fragment
  std::vector<ImageBox> boxes_;                         // of each fragment
};

}  // namespace

void check_invariants(const ProjectedMesh& projected, const VisibleFragments& fragments) {
  if (fragments.rings.values().size() <= 5000) Invariants(projected, fragments).check();
}

}  // namespace hsr::internal
