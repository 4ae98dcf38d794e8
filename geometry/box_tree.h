#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hsr {

/// A closed box in an image: two image coordinates and the nearness to the viewer (larger is nearer). Conservative: what it
/// stands for lies inside, whatever was rounded.
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

/// The boxes along a Z-order (Morton 1966) of their centres: what is near in the image is near in the order.
/// Ties by index; the same for any number of threads. Cost: O(n log n), parallel.
std::vector<std::uint32_t> z_order(std::span<const ImageBox> boxes);

/// A static tree over boxes: eight to a node along their Z-order, level upon level.
///
/// `visit(query, f)` calls f(index of box) for every box that overlaps the query in the image and reaches nearer than the
/// query's farthest point, i.e. for all that could hide some of it; stops when f returns false. Cost: build O(n log n),
/// parallel; a query O(log n + k) on meshes. The same order of calls for any number of threads.
/// `visit_touching` leaves out, too, what lies wholly nearer than the query: it calls for all that could touch it.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const ImageBox> boxes);

  template <class F>
  void visit(const ImageBox& query, F&& f) const {
    visit<false>(query, f);
  }
  template <class F>
  void visit_touching(const ImageBox& query, F&& f) const {
    visit<true>(query, f);
  }

 private:
  static constexpr std::size_t width = 8;
  /// Eight sibling boxes, a coordinate at a time.
  struct Node {
    std::array<std::array<float, width>, 2> low, high;
    std::array<float, width> farthest, nearest;
  };
  template <bool touching, class F>
  void visit(const ImageBox& query, F& f) const;

  std::vector<Node> nodes_;                 // level upon level, the leaves' level first
  std::vector<std::uint32_t> level_begin_;  // of each level in nodes_
  std::vector<std::uint32_t> order_;        // box at each place of the lowest level
};

template <bool touching, class F>
void BoxTree::visit(const ImageBox& query, F& f) const {
  if (nodes_.empty()) return;
  // Depth first; at most width - 1 siblings wait on each level.
  std::array<std::pair<std::uint32_t, std::uint32_t>, 12 * width> stack;  // level, node on it
  std::size_t top = 0;
  stack[top++] = {static_cast<std::uint32_t>(level_begin_.size() - 1), 0};
  while (top > 0) {
    const auto [level, place] = stack[--top];
    const Node& node = nodes_[level_begin_[level] + place];
    unsigned hit = 0;
    for (unsigned k = 0; k < width; ++k) {
      // Without branches: every comparison is made, and all must hold.
      unsigned overlaps = unsigned{node.low[0][k] <= query.high[0]} & unsigned{node.high[0][k] >= query.low[0]} &
                          unsigned{node.low[1][k] <= query.high[1]} & unsigned{node.high[1][k] >= query.low[1]} &
                          unsigned{node.nearest[k] >= query.farthest};
      if constexpr (touching) overlaps &= unsigned{node.farthest[k] <= query.nearest};
      hit |= overlaps << k;
    }
    // In order of nearness, the nearest last: first from the stack, and first to hide all of the query.
    std::array<std::uint32_t, width> hits;
    std::size_t count = 0;
    for (; hit != 0; hit &= hit - 1) {
      const auto k = static_cast<std::uint32_t>(__builtin_ctz(hit));
      std::size_t at = count++;
      for (; at > 0 && node.nearest[hits[at - 1]] > node.nearest[k]; --at) hits[at] = hits[at - 1];
      hits[at] = k;
    }
    if (level > 0) {
      for (std::size_t i = 0; i < count; ++i) stack[top++] = {level - 1, place * width + hits[i]};
    } else {
      for (std::size_t i = count; i-- > 0;)
        if (!f(order_[place * width + hits[i]])) return;
    }
  }
}

}  // namespace hsr
