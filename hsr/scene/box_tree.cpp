#include "hsr/scene/box_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A float below x, one above. A step to the next float always: what the conversion rounded need not be known.
float up(double x) {
  const auto f = static_cast<float>(x);
  if (f == 0) return std::numeric_limits<float>::denorm_min();
  if (f == infinity) return f;
  const auto bits = std::bit_cast<std::int32_t>(f);  // sign and magnitude: the next magnitude is the next number
  return std::bit_cast<float>(bits > 0 ? bits + 1 : bits - 1);
}
float down(double x) { return -up(-x); }

/// How far along a Hilbert curve through 2^16 x 2^16 cells a cell is: neighbours along the curve are neighbours.
std::uint32_t along_hilbert_curve(std::uint32_t x, std::uint32_t y) {
  // In each of its four orientations the curve goes through the quadrants, numbered 2 x + y, in an order of its own, and in
  // each of them on in an orientation of its own.
  constexpr std::array<std::array<std::uint8_t, 4>, 4> place = {{{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 3, 1, 0}, {2, 1, 3, 0}}};
  constexpr std::array<std::array<std::uint8_t, 4>, 4> on = {{{1, 0, 3, 0}, {0, 2, 1, 1}, {2, 1, 2, 3}, {3, 3, 0, 2}}};
  std::uint32_t all = 0;
  std::size_t orientation = 0;
  for (int bit = 15; bit >= 0; --bit) {
    const std::size_t quadrant = (x >> bit & 1U) << 1U | (y >> bit & 1U);
    all = all << 2U | place[orientation][quadrant];
    orientation = on[orientation][quadrant];
  }
  return all;
}

float finite(float x) { return std::clamp(x, std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()); }

std::array<double, 2> centre(const ImageBox& b) {
  return {(static_cast<double>(finite(b.low[0])) + finite(b.high[0])) / 2,
          (static_cast<double>(finite(b.low[1])) + finite(b.high[1])) / 2};
}

/// Where most of the centres are in one coordinate. In perspective a few lie a thousand times as far out as the others, and
/// must not take the digits of the order from them.
struct Spread {
  double middle = 0, half = 1;

  /// Ascending with x, below 2^16; nearly even around the middle.
  std::uint32_t cell(double x) const {
    const double s = (x - middle) / half, place = std::isfinite(s) ? 0.5 + 0.5 * s / (1 + std::fabs(s)) : x < middle ? 0 : 1;
    return static_cast<std::uint32_t>(place * 0xffff);
  }
};

Spread spread_of(std::span<const ImageBox> boxes, std::size_t coordinate) {
  std::vector<double> sample;
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / 1024);
  for (std::size_t i = 0; i < boxes.size(); i += step) sample.push_back(centre(boxes[i])[coordinate]);
  std::sort(sample.begin(), sample.end());
  const double middle = sample[sample.size() / 2], half = (sample[sample.size() * 9 / 10] - sample[sample.size() / 10]) / 2;
  return {middle, half > 0 ? half : std::max(sample.back() - sample.front(), 0x1p-1000)};
}

}  // namespace

ImageBox ImageBox::nothing() { return {{infinity, infinity}, {-infinity, -infinity}, infinity, -infinity}; }
ImageBox ImageBox::everything() { return {{-infinity, -infinity}, {infinity, infinity}, -infinity, infinity}; }

void ImageBox::add(const std::array<double, 3>& value, const std::array<double, 3>& error) {
  for (std::size_t k = 0; k < 3; ++k) {
    float& least = k < 2 ? low[k] : farthest;
    float& most = k < 2 ? high[k] : nearest;
    // One more rounding here: a relative 2^-52 of both terms covers it.
    const double margin = error[k] + (std::fabs(value[k]) + error[k]) * 0x1p-52;
    const double a = value[k] - margin, b = value[k] + margin;
    least = std::isnan(a) ? -infinity : std::min(least, down(a));
    most = std::isnan(b) ? infinity : std::max(most, up(b));
  }
}

void ImageBox::add(const ImageBox& box) {
  for (std::size_t k = 0; k < 2; ++k) {
    low[k] = std::min(low[k], box.low[k]);
    high[k] = std::max(high[k], box.high[k]);
  }
  farthest = std::min(farthest, box.farthest);
  nearest = std::max(nearest, box.nearest);
}

std::vector<std::uint32_t> hilbert_order(std::span<const ImageBox> boxes) {
  if (boxes.empty()) return {};
  const std::array<Spread, 2> spreads = {spread_of(boxes, 0), spread_of(boxes, 1)};
  struct Place {
    std::uint32_t along, box;
  };
  std::vector<Place> places(boxes.size()), sorted(boxes.size());
  tbb::parallel_for(Range(0, boxes.size(), 4096), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto c = centre(boxes[i]);
      places[i] = {along_hilbert_curve(spreads[0].cell(c[0]), spreads[1].cell(c[1])), static_cast<std::uint32_t>(i)};
    }
  });
  // By eleven bits at a time, the lowest first.
  constexpr unsigned bits = 11, digits = 1U << bits;
  for (unsigned shift = 0; shift < 32; shift += bits) {
    std::vector<std::uint32_t> first(digits + 1, 0);
    for (const Place& p : places) ++first[(p.along >> shift & (digits - 1)) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const Place& p : places) sorted[first[p.along >> shift & (digits - 1)]++] = p;
    places.swap(sorted);
  }
  std::vector<std::uint32_t> order(places.size());
  for (std::size_t i = 0; i < places.size();) {
    const std::size_t begin = i;
    for (; i < places.size() && places[i].along == places[begin].along; ++i) order[i] = places[i].box;
    // Of one place they ascend by index so far.
    if (i - begin > 1)
      std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(i),
                       [&](std::uint32_t a, std::uint32_t b) { return boxes[a].nearest > boxes[b].nearest; });
  }
  return order;
}

BoxTree::BoxTree(std::span<const ImageBox> boxes) : order_(hilbert_order(boxes)) {
  if (boxes.empty()) return;
  // An empty place holds no numbers: it overlaps nothing, not even an unbounded query.
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr ImageBox none = {{nan, nan}, {nan, nan}, nan, nan};
  const auto set = [](Node& node, std::size_t k, const ImageBox& b) {
    for (std::size_t d = 0; d < 2; ++d) {
      node.low[d][k] = b.low[d];
      node.high[d][k] = b.high[d];
    }
    node.farthest[k] = b.farthest;
    node.nearest[k] = b.nearest;
  };
  std::size_t below = order_.size();  // boxes on the level below
  std::size_t node_count = 0, on_level = below;
  do {
    on_level = (on_level + width - 1) / width;
    node_count += on_level;
  } while (on_level > 1);
  nodes_.reserve(node_count);
  std::vector<ImageBox> level_boxes;
  for (bool leaves = true; leaves || below > 1; leaves = false) {
    const std::size_t count = (below + width - 1) / width, begin = nodes_.size();
    level_begin_.push_back(static_cast<std::uint32_t>(begin));
    nodes_.resize(begin + count);
    if (!leaves) children_.resize(begin + count - level_begin_[1]);
    std::vector<ImageBox> united(count, ImageBox::nothing());
    tbb::parallel_for(Range(0, count, 1024), [&](const Range& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const std::size_t first = i * width, filled = std::min(width, below - first);
        const auto box = [&](std::uint32_t k) -> const ImageBox& {
          return leaves ? boxes[order_[first + k]] : level_boxes[first + k];
        };
        // The nearest first, of equals the first.
        static_assert(width == 8, "children_ has three bits for each");
        std::array<std::uint32_t, width> by_nearness = {0, 1, 2, 3, 4, 5, 6, 7};
        for (std::uint32_t k = 1; k < filled; ++k) {
          std::size_t at = k;
          for (; at > 0 && box(by_nearness[at - 1]).nearest < box(k).nearest; --at) by_nearness[at] = by_nearness[at - 1];
          by_nearness[at] = k;
        }
        std::uint32_t children = 0;
        for (std::uint32_t k = 0; k < width; ++k) {
          children |= by_nearness[k] << 3 * k;
          set(nodes_[begin + i], k, k < filled ? box(by_nearness[k]) : none);
          if (k < filled) united[i].add(box(k));
        }
        if (!leaves) {
          children_[begin - level_begin_[1] + i] = children;
          continue;
        }
        std::array<std::uint32_t, width> sorted;
        for (std::size_t k = 0; k < filled; ++k) sorted[k] = order_[first + by_nearness[k]];
        std::copy_n(sorted.begin(), filled, order_.begin() + static_cast<std::ptrdiff_t>(first));
      }
    });
    level_boxes = std::move(united);
    below = count;
  }
}

}  // namespace hsr::internal
