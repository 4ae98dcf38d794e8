#include "hsr/drawing/cut_seams.h"

#include <algorithm>
#include <tuple>

#include "hsr/drawing/paint_layers.h"
#include "hsr/drawing/paper_polygons.h"
#include "hsr/drawing/paper_sides.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

namespace {

using Ring = std::vector<PaperPoint>;

ImageBox box_of(const Ring& ring) {
  ImageBox box = ImageBox::nothing();
  for (const PaperPoint& p : ring) box.add({static_cast<double>(p.x), static_cast<double>(p.y), 0}, {});
  return box;
}

double turn(const PaperPoint& p, const PaperPoint& q, const PaperPoint& r) {
  return static_cast<double>(q.x - p.x) * static_cast<double>(r.y - q.y) -
         static_cast<double>(q.y - p.y) * static_cast<double>(r.x - q.x);
}

/// Andrew's monotone chain (1979): the corners of the convex hull, in turn.
Ring convex_hull(Ring points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Ring hull;
  for (int half = 0; half < 2; ++half, std::reverse(points.begin(), points.end())) {
    const std::size_t first = hull.size();
    for (const PaperPoint& p : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other half begins there
  }
  return hull;
}

/// Of a tent on a side its convex hull, which lies in a convex polygon as its corners do: those besides the ends of the side, from its
/// start to its end.
Ring hull_of_tent(const PaperSide& side, const Ring& top) {
  Ring hull = top;
  hull.insert(hull.end(), {side.from, side.to});
  hull = convex_hull(std::move(hull));
  const auto start = std::find(hull.begin(), hull.end(), side.from);
  std::rotate(hull.begin(), start, hull.end());
  if (hull.size() > 1 && hull[1] == side.to) std::reverse(hull.begin() + 1, hull.end());
  return {hull.begin() + 1, hull.end() - 1};
}

class CutCloser {
 public:
  CutCloser(std::vector<Ring>& rings, std::span<const std::uint32_t> facets) : rings_(rings), facets_(facets) {
    std::vector<ImageBox> boxes;
    boxes.reserve(rings.size());
    for (const Ring& ring : rings) boxes.push_back(box_of(ring));
    tree_ = BoxTree(boxes);
  }

  void run() {
    const PaperPolygons polygons(conforming(sides_of_cut_faces()));
    const std::vector<PaperSide>& sides = polygons.sides();
    struct Key {
      std::uint32_t facet;
      PaperPoint low, high;
      std::uint32_t side;
    };
    std::vector<Key> keys;
    for (std::uint32_t k = 0; k < sides.size(); ++k)
      keys.push_back({facets_[sides[k].owner], std::min(sides[k].from, sides[k].to), std::max(sides[k].from, sides[k].to), k});
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return std::tie(a.facet, a.low, a.high, a.side) < std::tie(b.facet, b.low, b.high, b.side);
    });
    std::vector<Ring> tents(sides.size());
    for (std::size_t k = 1; k < keys.size(); ++k) {
      const Key &a = keys[k - 1], &b = keys[k];
      if (a.facet != b.facet || a.low != b.low || a.high != b.high) continue;
      // Owners ascend with the sides.
      const PaperSide &earlier = sides[a.side], &later = sides[b.side];
      if (earlier.from != later.to || earlier.owner + 1 >= later.owner) continue;
      Ring whole = hull_of_tent(later, polygons.tent(a.side));
      if (whole.empty()) continue;
      Ring& top = tents[b.side] = whole;
      whole.insert(whole.begin(), later.from);
      whole.push_back(later.to);
      if (!is_free(whole, earlier.owner, later.owner)) top.clear();
    }
    add(sides, tents);
  }

 private:
  std::vector<PaperSide> sides_of_cut_faces() const {
    std::vector<std::uint32_t> sorted(facets_.begin(), facets_.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<PaperSide> sides;
    for (std::uint32_t i = 0; i < rings_.size(); ++i) {
      const auto [first, end] = std::equal_range(sorted.begin(), sorted.end(), facets_[i]);
      if (end - first < 2) continue;
      append_sides(rings_[i], i, sides);
    }
    return sides;
  }

  /// Nothing that is painted between the two lies there.
  bool is_free(const Ring& tent, std::uint32_t earlier, std::uint32_t later) const {
    bool is_free = true;
    tree_.visit_touching(box_of(tent), [&](std::uint32_t i) {
      is_free = i <= earlier || i >= later || !overlap(tent, rings_[i]);
      return is_free;
    });
    return is_free;
  }

  /// Sides with a tent go around it.
  void add(const std::vector<PaperSide>& sides, const std::vector<Ring>& tents) {
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      Ring ring;
      bool is_changed = false;
      for (; end < sides.size() && sides[end].owner == sides[i].owner; ++end) {
        ring.push_back(sides[end].from);
        is_changed = is_changed || !tents[end].empty();
        ring.insert(ring.end(), tents[end].begin(), tents[end].end());
      }
      if (is_changed) rings_[sides[i].owner] = std::move(ring);
    }
  }

  std::vector<Ring>& rings_;
  std::span<const std::uint32_t> facets_;
  BoxTree tree_;
};

}  // namespace

void close_cuts(std::vector<Ring>& rings, std::span<const std::uint32_t> facets) { CutCloser(rings, facets).run(); }

}  // namespace hsr::internal
