#include "hsr/drawing/end_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace hsr::internal {

namespace {

constexpr std::uint32_t leaf_size = 8;

double distance(const PaperPoint& a, const PaperPoint& b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

bool is_nearer(const NearestEnd& a, const NearestEnd& b) {
  return std::tie(a.distance, a.number) < std::tie(b.distance, b.number);
}

}  // namespace

EndTree::EndTree(std::vector<PaperPoint> points)
    : points_(std::move(points)), order_(points_.size()), leaf_of_(points_.size()), is_out_(points_.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.emplace_back();
  nodes_[0].end = static_cast<std::uint32_t>(order_.size());
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(node);
}

void EndTree::split(std::uint32_t number) {
  Node node = nodes_[number];
  node.alive = node.end - node.begin;
  for (int k = 0; k < 2; ++k) {
    node.low[k] = std::numeric_limits<std::int64_t>::max();
    node.high[k] = std::numeric_limits<std::int64_t>::min();
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const std::int64_t at[2] = {points_[order_[i]].x, points_[order_[i]].y};
    for (int k = 0; k < 2; ++k) {
      node.low[k] = std::min(node.low[k], at[k]);
      node.high[k] = std::max(node.high[k], at[k]);
    }
    leaf_of_[order_[i]] = number;
  }
  if (node.alive > leaf_size) {
    const bool by_x = node.high[0] - node.low[0] >= node.high[1] - node.low[1];
    const std::uint32_t middle = node.begin + node.alive / 2;
    std::nth_element(
        order_.begin() + node.begin, order_.begin() + middle, order_.begin() + node.end, [&](std::uint32_t i, std::uint32_t j) {
          const PaperPoint &p = points_[i], &q = points_[j];
          return by_x ? std::tie(p.x, p.y, i) < std::tie(q.x, q.y, j) : std::tie(p.y, p.x, i) < std::tie(q.y, q.x, j);
        });
    node.left = static_cast<std::uint32_t>(nodes_.size());
    Node left, right;
    left.parent = right.parent = number;
    left.begin = node.begin;
    left.end = right.begin = middle;
    right.end = node.end;
    nodes_.push_back(left);
    nodes_.push_back(right);
  }
  nodes_[number] = node;
}

double EndTree::distance_to(const Node& node, const PaperPoint& place) const {
  const std::int64_t at[2] = {place.x, place.y};
  double d[2];
  for (int k = 0; k < 2; ++k)
    d[k] = static_cast<double>(std::max({std::int64_t{0}, node.low[k] - at[k], at[k] - node.high[k]}));
  return std::hypot(d[0], d[1]);
}

/// Calls visit_end for points that are left, near ones early, with their distances, until it returns less than what is left to see.
template <class Visit>
void EndTree::visit(const PaperPoint& place, const Visit& visit_end) const {
  std::vector<std::pair<double, std::uint32_t>> stack = {{0, 0}};
  double limit = std::numeric_limits<double>::infinity();
  while (!stack.empty()) {
    const auto [far, number] = stack.back();
    stack.pop_back();
    const Node& node = nodes_[number];
    if (far > limit || limit <= 0 || node.alive == 0) continue;  // many may be at one place
    if (node.left == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (is_out_[order_[i]] == 0) limit = visit_end(NearestEnd{distance(place, points_[order_[i]]), order_[i]});
      continue;
    }
    std::pair<double, std::uint32_t> a = {distance_to(nodes_[node.left], place), node.left};
    std::pair<double, std::uint32_t> b = {distance_to(nodes_[node.left + 1], place), node.left + 1};
    if (a.first < b.first) std::swap(a, b);
    stack.push_back(a);
    stack.push_back(b);
  }
}

std::optional<NearestEnd> EndTree::nearest(const PaperPoint& place) const {
  std::optional<NearestEnd> best;
  visit(place, [&](const NearestEnd& end) {
    if (!best || is_nearer(end, *best)) best = end;
    return best->distance;
  });
  return best;
}

std::vector<std::uint32_t> EndTree::nearest(const PaperPoint& place, std::size_t count,
                                            const std::function<bool(std::uint32_t)>& passed_over) const {
  std::vector<NearestEnd> best;  // a heap, the farthest on top
  visit(place, [&](const NearestEnd& end) {
    if (!passed_over(end.number) && (best.size() < count || is_nearer(end, best.front()))) {
      if (best.size() == count) {
        std::pop_heap(best.begin(), best.end(), is_nearer);
        best.pop_back();
      }
      best.push_back(end);
      std::push_heap(best.begin(), best.end(), is_nearer);
    }
    return best.size() < count ? std::numeric_limits<double>::infinity() : best.front().distance;
  });
  std::sort_heap(best.begin(), best.end(), is_nearer);
  std::vector<std::uint32_t> numbers;
  for (const NearestEnd& end : best) numbers.push_back(end.number);
  return numbers;
}

void EndTree::take_out(std::uint32_t number) {
  if (is_out_[number] != 0) return;
  is_out_[number] = 1;
  for (std::uint32_t node = leaf_of_[number];; node = nodes_[node].parent) {
    --nodes_[node].alive;
    if (node == 0) return;
  }
}

}  // namespace hsr::internal
