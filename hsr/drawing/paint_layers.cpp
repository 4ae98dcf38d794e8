#include "hsr/drawing/paint_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hsr/scene/box_tree.h"

namespace hsr::internal {

namespace {

constexpr double rounding = 2;  // thousandths of a millimetre

/// A side of p has all of q beyond it, but for rounding: two convex polygons are apart if this holds for one of them.
bool has_side_between(const std::vector<PaperPoint>& p, const std::vector<PaperPoint>& q) {
  // Which way round p goes: its corners may be in either order.
  double twice_area = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k)
    twice_area += static_cast<double>(p[k].x - p[0].x) * static_cast<double>(p[k + 1].y - p[0].y) -
                  static_cast<double>(p[k].y - p[0].y) * static_cast<double>(p[k + 1].x - p[0].x);
  const double turn = twice_area < 0 ? -1 : 1;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const PaperPoint &a = p[k], &b = p[(k + 1) % p.size()];
    const double x = static_cast<double>(b.x - a.x), y = static_cast<double>(b.y - a.y), length = std::hypot(x, y);
    if (!(length > 0)) continue;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const PaperPoint& c : q)
      deepest = std::max(deepest, turn * (x * static_cast<double>(c.y - a.y) - y * static_cast<double>(c.x - a.x)) / length);
    if (deepest <= rounding) return true;
  }
  return false;
}

}  // namespace

bool overlap(const std::vector<PaperPoint>& p, const std::vector<PaperPoint>& q) {
  return !p.empty() && !q.empty() && !has_side_between(p, q) && !has_side_between(q, p);
}

std::vector<std::uint32_t> paint_layers(const std::vector<std::vector<PaperPoint>>& polygons) {
  std::vector<ImageBox> boxes;
  for (const auto& polygon : polygons) {
    boxes.push_back(ImageBox::nothing());
    for (const PaperPoint& p : polygon) boxes.back().add({static_cast<double>(p.x), static_cast<double>(p.y), 0}, {});
  }
  const BoxTree tree(boxes);
  std::vector<std::array<std::uint32_t, 2>> over;  // later, earlier
  BoxTree::PairSearch search;
  for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
    tree.visit_pairs(leaf, search, [&](std::uint32_t i, std::uint32_t k) {
      if (!overlap(polygons[i], polygons[k])) return;
      over.push_back({std::max(i, k), std::min(i, k)});
    });
  std::sort(over.begin(), over.end());
  std::vector<std::uint32_t> layer(polygons.size(), 0);
  for (const auto& [later, earlier] : over) layer[later] = std::max(layer[later], layer[earlier] + 1);
  return layer;
}

}  // namespace hsr::internal
