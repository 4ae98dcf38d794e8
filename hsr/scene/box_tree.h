#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/simd.h"

namespace hsr::internal {

/// A closed box in an image: two image coordinates and the nearness to the viewer (greater is nearer). Conservative: whatever
/// was rounded, the thing that it bounds lies inside.
struct ImageBox {
  std::array<float, 2> low, high;
  float farthest, nearest;

  /// Grows the box to contain the interval [value - error, value + error] of each coordinate; an unknown value makes it
  /// unbounded.
  void add(const std::array<double, 3>& value, const std::array<double, 3>& error);
  void add(const ImageBox& box);
  static ImageBox nothing();
  static ImageBox everything();
};

/// The boxes along a Hilbert curve through the image, by their centres: what is near in the order is near in the image. Of one
/// place the nearer first, then by index; the same for any number of threads. Cost: O(n log n), parallel.
std::vector<std::uint32_t> hilbert_order(std::span<const ImageBox> boxes);

/// A static tree over boxes: eight to a node along their Hilbert order, level upon level.
///
/// `visit(query, f)` calls f(index of box) for every box that overlaps the query in the image and reaches nearer than the
/// query's farthest point, i.e. for all that could hide some of it, roughly the nearest first; stops when f returns false.
/// `visit_touching` leaves out, too, what lies wholly nearer than the query: it calls for all that could touch it.
/// Cost: build O(n log n), parallel; a query O(log n + k) on meshes. The same order of calls for any number of threads.
///
/// Many queries close to one another share the way down: `leaves` finds the leaves that overlap all of them together, and
/// `visit_leaf` looks for each query at one leaf. Leaves with a lower number than `first` are passed over.
/// Source: Kamel & Faloutsos 1993 (R-trees packed along a Hilbert curve).
class BoxTree {
 public:
  enum class Depth { hiding, touching, any };
  /// What visit_pairs() has found for a leaf and its siblings.
  struct PairSearch {
    std::uint32_t parent = 0xffffffffU;
    bool is_shared = false;  // the parents serve all of its leaves: there are not too many
    std::vector<std::uint32_t> parents;
    /// Which boxes of this leaf touch the box around another one, and which of that one touch the box around this.
    struct Leaf {
      std::uint32_t leaf;
      unsigned ours, theirs;
    };
    std::vector<Leaf> leaves;
    std::vector<std::uint32_t> found;  // instead, for one box
  };

  static constexpr std::size_t width = 8;  ///< boxes of a leaf, at most

  BoxTree() = default;
  explicit BoxTree(std::span<const ImageBox> boxes);

  bool is_empty() const { return nodes_.empty(); }

  template <class F>
  void visit(const ImageBox& query, F&& f) const {
    visit_boxes<Depth::hiding>(query, [&](std::uint32_t i, std::uint32_t /*at*/) { return f(i); });
  }
  template <class F>
  void visit_touching(const ImageBox& query, F&& f) const {
    visit_boxes<Depth::touching>(query, [&](std::uint32_t i, std::uint32_t /*at*/) { return f(i); });
  }

  /// Like visit(), for any kind of overlap, and calls f(index of box, position of the box along the leaves).
  template <Depth depth, class F>
  void visit_boxes(const ImageBox& query, F&& f) const {
    visit_leaves<depth>(query, [&](std::uint32_t leaf, unsigned hit) {
      for (; hit != 0; hit &= hit - 1) {
        const std::uint32_t at = leaf * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(__builtin_ctz(hit));
        if (!f(order_[at], at)) return false;
      }
      return true;
    });
  }
  /// The same, a leaf at a time: f(leaf, bits), the boxes of it that overlap.
  template <Depth depth, class F>
  void visit_leaves(const ImageBox& query, F&& f) const;

  /// Appends the leaves that overlap the query, until there are `limit` of them. False: there are more.
  template <Depth depth>
  bool leaves(const ImageBox& query, std::size_t limit, std::vector<std::uint32_t>& found, std::uint32_t first = 0) const {
    return nodes<depth>(query, 0, limit, found, first);
  }
  std::uint32_t leaf_count() const { return static_cast<std::uint32_t>((order_.size() + width - 1) / width); }
  /// Calls f(i, k) for every two boxes that touch (any: in the image), the one in this leaf and the other later in the tree:
  /// each pair once, over all leaves. @param search serves leaf after leaf
  template <Depth depth = Depth::touching, class F>
  void visit_pairs(std::uint32_t leaf, PairSearch& search, F&& f) const {
    visit_pairs_by_leaf<depth>(leaf, search, [&](std::size_t k, std::uint32_t other, unsigned hit) {
      for (; hit != 0; hit &= hit - 1)
        f(order_[leaf * width + k], order_[other * width + static_cast<unsigned>(__builtin_ctz(hit))]);
    });
  }
  /// The same pairs, a leaf at a time: f(k, other, bits), box k of this leaf touches those of the other leaf whose bits are set.
  template <Depth depth = Depth::touching, class F>
  void visit_pairs_by_leaf(std::uint32_t leaf, PairSearch& search, F&& f) const;
  /// How many boxes a leaf has, and which is the one at a place of it.
  std::size_t leaf_size(std::uint32_t leaf) const { return std::min(width, order_.size() - leaf * width); }
  std::uint32_t box_at(std::uint32_t leaf, std::size_t k) const { return order_[leaf * width + k]; }
  /// The boxes of a leaf that overlap the query, a bit each.
  template <Depth depth>
  unsigned overlaps(std::uint32_t leaf, const ImageBox& query) const {
    return overlaps<depth>(nodes_[leaf], query);
  }
  /// False: f returned false.
  template <Depth depth, class F>
  bool visit_leaf(std::uint32_t leaf, const ImageBox& query, F&& f) const {
    for (unsigned hit = overlaps<depth>(leaf, query); hit != 0; hit &= hit - 1)
      if (!f(order_[leaf * width + static_cast<unsigned>(__builtin_ctz(hit))])) return false;
    return true;
  }

 private:
  /// Eight sibling boxes, the nearest first, a coordinate at a time.
  struct alignas(32) Node {
    std::array<std::array<float, width>, 2> low, high;
    std::array<float, width> farthest, nearest;
  };
  /// Bit k: box k overlaps the query.
  template <Depth depth>
  static unsigned overlaps(const Node& node, const ImageBox& query);
  /// Appends the nodes of a level in which some box overlaps the query, but not those whose leaves are all lower than `first`.
  template <Depth depth>
  bool nodes(const ImageBox& query, std::uint32_t level, std::size_t limit, std::vector<std::uint32_t>& found,
             std::uint32_t first) const;
  /// The box around the boxes of a node. Unused slots hold NaN and add nothing: std::min and std::max with a NaN as their
  /// second argument return the first.
  static ImageBox united(const Node& n) {
    ImageBox all = ImageBox::nothing();
    for (std::size_t k = 0; k < width; ++k) {
      for (std::size_t d = 0; d < 2; ++d) {
        all.low[d] = std::min(all.low[d], n.low[d][k]);
        all.high[d] = std::max(all.high[d], n.high[d][k]);
      }
      all.farthest = std::min(all.farthest, n.farthest[k]);
      all.nearest = std::max(all.nearest, n.nearest[k]);
    }
    return all;
  }
  ImageBox box(std::uint32_t leaf, std::size_t k) const {
    const Node& n = nodes_[leaf];
    return {{n.low[0][k], n.low[1][k]}, {n.high[0][k], n.high[1][k]}, n.farthest[k], n.nearest[k]};
  }

  static void prefetch(const Node* node) {
    for (std::size_t line = 0; line < sizeof(Node); line += 64) __builtin_prefetch(reinterpret_cast<const char*>(node) + line);
  }
  /// The place on its own level of box k of an inner node.
  std::uint32_t child(std::uint32_t node, std::uint32_t place, std::uint32_t k) const {
    return place * static_cast<std::uint32_t>(width) + (children_[node - level_begin_[1]] >> 3 * k & 7U);
  }

  std::vector<Node> nodes_;                 // level upon level, the leaves' level first
  std::vector<std::uint32_t> children_;     // of each inner node, three bits a box: which of its eight it is along the order
  std::vector<std::uint32_t> level_begin_;  // of each level in nodes_
  std::vector<std::uint32_t> order_;        // box at each place of the lowest level
};

template <BoxTree::Depth depth>
unsigned BoxTree::overlaps(const Node& node, const ImageBox& query) {
  const auto four = [&](std::size_t k) {
    const auto at = [&](const std::array<float, width>& x) { return FourFloats::load(&x[k]); };
    FourFloats all = (at(node.low[0]) <= FourFloats::all(query.high[0])) & (at(node.high[0]) >= FourFloats::all(query.low[0])) &
                     (at(node.low[1]) <= FourFloats::all(query.high[1])) & (at(node.high[1]) >= FourFloats::all(query.low[1]));
    if constexpr (depth != Depth::any) all = all & (at(node.nearest) >= FourFloats::all(query.farthest));
    if constexpr (depth == Depth::touching) all = all & (at(node.farthest) <= FourFloats::all(query.nearest));
    return all.bits();
  };
  return four(0) | four(4) << 4U;
}

template <BoxTree::Depth depth, class F>
void BoxTree::visit_leaves(const ImageBox& query, F&& f) const {
  if (nodes_.empty()) return;
  // Depth first; at most width - 1 siblings wait on each level.
  std::array<std::pair<std::uint32_t, std::uint32_t>, 12 * width> stack;  // level, node on it
  std::size_t top = 0;
  stack[top++] = {static_cast<std::uint32_t>(level_begin_.size() - 1), 0};
  while (top > 0) {
    const auto [level, place] = stack[--top];
    const std::uint32_t node = level_begin_[level] + place;
    unsigned hit = overlaps<depth>(nodes_[node], query);
    if (level > 0) {
      // The nearest last: first from the stack, and first to hide all of the query.
      while (hit != 0) {
        const auto k = static_cast<std::uint32_t>(31 - __builtin_clz(hit));
        const std::uint32_t on = child(node, place, k);
        stack[top++] = {level - 1, on};
        prefetch(&nodes_[level_begin_[level - 1] + on]);
        hit ^= 1U << k;
      }
    } else if (hit != 0 && !f(place, hit)) {
      return;
    }
  }
}

template <BoxTree::Depth depth>
bool BoxTree::nodes(const ImageBox& query, std::uint32_t wanted, std::size_t limit, std::vector<std::uint32_t>& found,
                    std::uint32_t first) const {
  if (nodes_.empty()) return true;
  const std::size_t end = found.size() + limit;
  std::array<std::pair<std::uint32_t, std::uint32_t>, 12 * width> stack;
  std::size_t top = 0;
  stack[top++] = {static_cast<std::uint32_t>(level_begin_.size() - 1), 0};
  while (top > 0) {
    const auto [level, place] = stack[--top];
    if ((std::uint64_t{place} + 1) << 3 * level <= first) continue;  // all of its leaves are before
    const std::uint32_t node = level_begin_[level] + place;
    unsigned hit = overlaps<depth>(nodes_[node], query);
    if (level == wanted) {
      if (hit == 0) continue;
      if (found.size() == end) return false;
      found.push_back(place);
    } else
      for (; hit != 0; hit &= hit - 1)
        stack[top++] = {level - 1, child(node, place, static_cast<std::uint32_t>(__builtin_ctz(hit)))};
  }
  return true;
}

template <BoxTree::Depth depth, class F>
void BoxTree::visit_pairs_by_leaf(std::uint32_t leaf, PairSearch& search, F&& f) const {
  constexpr std::size_t limit = 64, none = 0xffffffffU;
  const bool has_parents = level_begin_.size() > 1;
  const auto parent = static_cast<std::uint32_t>(leaf / width);
  if (search.parent != parent) {
    search.parent = parent;
    search.parents.clear();
    search.is_shared = !has_parents || nodes<depth>(united(nodes_[level_begin_[1] + parent]), 1, limit, search.parents, leaf);
  }
  const auto add = [&](std::uint32_t other, unsigned ours, const ImageBox& query) {
    const unsigned theirs = overlaps<depth>(nodes_[other], query);
    if (ours != 0 && theirs != 0) search.leaves.push_back({other, ours, theirs});
  };
  // The leaves from this one on that may have anything.
  const std::size_t count = leaf_size(leaf);
  if (search.is_shared) {
    search.leaves.clear();
    const ImageBox query = united(nodes_[leaf]);
    if (!has_parents) add(leaf, (1U << count) - 1, query);
    for (const std::uint32_t p : search.parents) {
      const Node& node = nodes_[level_begin_[1] + p];
      for (unsigned hit = overlaps<depth>(node, query); hit != 0; hit &= hit - 1) {
        const auto m = static_cast<std::uint32_t>(__builtin_ctz(hit));
        const std::uint32_t other = child(level_begin_[1] + p, p, m);
        if (other >= leaf) add(other, overlaps<depth>(nodes_[leaf], box(level_begin_[1] + p, m)), query);
      }
    }
  }
  const auto visit = [&](std::size_t k, const ImageBox& query, std::uint32_t other, unsigned among) {
    unsigned hit = overlaps<depth>(nodes_[other], query) & among;
    if (other == leaf) hit &= ~0U << (k + 1);
    if (hit != 0) f(k, other, hit);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const ImageBox query = box(leaf, k);
    if (search.is_shared) {
      for (const auto& [other, ours, theirs] : search.leaves)
        if ((ours >> k & 1U) != 0) visit(k, query, other, theirs);
      continue;
    }
    search.found.clear();
    leaves<depth>(query, none, search.found, leaf);
    for (const std::uint32_t other : search.found) visit(k, query, other, ~0U);
  }
}

}  // namespace hsr::internal
