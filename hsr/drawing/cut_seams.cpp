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
      // From the start of the later side to its end: the other way round.
      Ring top = polygons.tent(a.side);
      std::reverse(top.begin(), top.end());
      Ring whole = {later.from};
      whole.insert(whole.end(), top.begin(), top.end());
      whole.push_back(later.to);
      if (!top.empty() && is_free(whole, earlier.owner, later.owner)) tents[b.side] = std::move(top);
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
      for (std::size_t k = 0; k < rings_[i].size(); ++k)
        sides.push_back({rings_[i][k], rings_[i][(k + 1) % rings_[i].size()], i});
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
      if (is_changed) changed_.emplace_back(sides[i].owner, std::move(ring));
    }
    for (auto& [owner, ring] : changed_) rings_[owner] = std::move(ring);
  }

  std::vector<Ring>& rings_;
  std::span<const std::uint32_t> facets_;
  BoxTree tree_;
  std::vector<std::pair<std::uint32_t, Ring>> changed_;
};

}  // namespace

void close_cuts(std::vector<Ring>& rings, std::span<const std::uint32_t> facets) { CutCloser(rings, facets).run(); }

}  // namespace hsr::internal
