#include "hsr/scene/box_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace hsr;
using namespace hsr::internal;

namespace {

ImageBox box_at(double u, double v, double depth, double half) {
  ImageBox box = ImageBox::nothing();
  box.add({u, v, depth}, {half, half, half});
  return box;
}

bool overlap(const ImageBox& a, const ImageBox& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] || a.high[k] < b.low[k]) return false;
  return true;
}

std::vector<std::uint32_t> found(const BoxTree& tree, const ImageBox& query) {
  std::vector<std::uint32_t> boxes;
  tree.visit(query, [&](std::uint32_t i) {
    boxes.push_back(i);
    return true;
  });
  std::sort(boxes.begin(), boxes.end());
  return boxes;
}

}  // namespace

TEST_CASE("a box contains what it was grown by, whatever the float rounds", "[geometry][box_tree]") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 10000; ++i) {
    const double x =
        std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), static_cast<int>(random() % 2000) - 1063);
    if (!std::isfinite(x)) continue;
    const double error = std::fabs(x) * 0x1p-40;
    const ImageBox box = box_at(x, -x, x, error);
    CHECK((static_cast<double>(box.low[0]) <= x - error && static_cast<double>(box.high[0]) >= x + error));
    CHECK((static_cast<double>(box.low[1]) <= -x - error && static_cast<double>(box.high[1]) >= -x + error));
    CHECK((static_cast<double>(box.farthest) <= x - error && static_cast<double>(box.nearest) >= x + error));
  }
}

TEST_CASE("a box of what is not a number is unbounded", "[geometry][box_tree]") {
  ImageBox box = ImageBox::nothing();
  box.add({std::nan(""), 0, 0}, {0, std::nan(""), std::numeric_limits<double>::infinity()});
  CHECK((box.low[0] < -1e38F && box.high[0] > 1e38F && box.low[1] < -1e38F && box.high[1] > 1e38F));
  CHECK((box.farthest < -1e38F && box.nearest > 1e38F));
}

TEST_CASE("the tree finds what a search of all boxes finds", "[geometry][box_tree]") {
  std::mt19937_64 random(5);
  const auto unit = [&] { return static_cast<double>(random() % 10007) / 10007; };
  for (const std::size_t n : {0, 1, 2, 7, 8, 9, 64, 65, 513, 5000}) {
    std::vector<ImageBox> boxes;
    for (std::size_t i = 0; i < n; ++i) {
      // some far out, some unbounded, many in one place
      const double far = random() % 16 == 0 ? 1e6 : 1;
      boxes.push_back(random() % 200 == 0 ? ImageBox::everything()
                                          : box_at(far * unit(), random() % 8 == 0 ? 0 : unit(), unit(), 0.02 * unit()));
    }
    const BoxTree tree(boxes);
    for (int q = 0; q < 50; ++q) {
      const ImageBox query = q == 0 ? ImageBox::everything() : box_at(unit(), unit(), unit(), 0.1 * unit());
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < n; ++i)
        if (overlap(boxes[i], query) && boxes[i].nearest >= query.farthest) expected.push_back(i);
      CHECK(found(tree, query) == expected);
    }
  }
}

TEST_CASE("the tree finds every two boxes that touch, once", "[geometry][box_tree]") {
  std::mt19937_64 random(6);
  const auto unit = [&] { return static_cast<double>(random() % 10007) / 10007; };
  for (const std::size_t n : {0, 1, 2, 8, 9, 65, 600}) {
    for (const double size : {0.02, 0.5}) {  // of the larger ones more leaves overlap than are shared
      std::vector<ImageBox> boxes;
      for (std::size_t i = 0; i < n; ++i)
        boxes.push_back(random() % 200 == 0 ? ImageBox::everything() : box_at(unit(), unit(), unit(), size * unit()));
      std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, pairs;
      for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t k = i + 1; k < n; ++k)
          if (overlap(boxes[i], boxes[k]) && boxes[i].nearest >= boxes[k].farthest && boxes[k].nearest >= boxes[i].farthest)
            expected.emplace_back(i, k);
      const BoxTree tree(boxes);
      BoxTree::PairSearch search;
      for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
        tree.visit_pairs(leaf, search,
                         [&](std::uint32_t i, std::uint32_t k) { pairs.emplace_back(std::min(i, k), std::max(i, k)); });
      std::sort(pairs.begin(), pairs.end());
      CHECK(pairs == expected);
    }
  }
}

TEST_CASE("a visit stops when it is told to", "[geometry][box_tree]") {
  const BoxTree tree(std::vector<ImageBox>(1000, box_at(0, 0, 0, 1)));
  int calls = 0;
  tree.visit(ImageBox::everything(), [&](std::uint32_t) { return ++calls < 10; });
  CHECK(calls == 10);
}

TEST_CASE("a Hilbert order holds each box once, equal boxes by index and the nearer of one place first",
          "[geometry][box_tree]") {
  const std::vector<ImageBox> equal(100, box_at(1, 2, 3, 0));
  const auto order = hilbert_order(equal);
  REQUIRE(order.size() == 100);
  for (std::uint32_t i = 0; i < 100; ++i) CHECK(order[i] == i);
  CHECK(hilbert_order({}).empty());
  CHECK(hilbert_order(std::vector{box_at(1, 2, 3, 0), box_at(1, 2, 5, 0), box_at(1, 2, 4, 0)}) ==
        std::vector<std::uint32_t>{1, 2, 0});
}

TEST_CASE("of the points of a grid each is the neighbour of the next along the Hilbert curve", "[geometry][box_tree]") {
  constexpr std::uint32_t side = 32;
  std::vector<ImageBox> grid;
  for (std::uint32_t i = 0; i < side * side; ++i) grid.push_back(box_at(i % side, i / side, 0, 0));
  const auto order = hilbert_order(grid);
  std::size_t neighbours = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto gap = [](std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; };
    neighbours += gap(order[i] % side, order[i - 1] % side) + gap(order[i] / side, order[i - 1] / side) == 1 ? 1 : 0;
  }
  // The cells of the curve are smaller than those of the grid, and not even: a corner is cut now and then. Along a Z-order it
  // is half of them.
  CHECK(neighbours > 800);
}
