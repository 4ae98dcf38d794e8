#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// Where a pen can begin: a place, numbered as it was given.
struct NearestEnd {
  double distance;  // micrometres
  std::uint32_t number;
};

/// Points of the paper, of which the nearest to a place is looked for; any can be taken out. A k-d tree (Bentley 1975).
///
/// Of those that are equally near the one with the lowest number counts; of those at the place itself the same ones each time. Cost: O(n log n) to build, O(log n) to take one out, and
/// O(log n) to look for one where points are spread.
class EndTree {
 public:
  explicit EndTree(std::vector<PaperPoint> points);

  /// Nothing: all are taken out.
  std::optional<NearestEnd> nearest(const PaperPoint& place) const;
  /// Up to `count` of those that are left, the nearest first. @param passed_over those that do not count
  std::vector<std::uint32_t> nearest(const PaperPoint& place, std::size_t count,
                                     const std::function<bool(std::uint32_t)>& passed_over) const;
  void take_out(std::uint32_t number);

 private:
  struct Node {
    std::int64_t low[2], high[2];      // of its points
    std::uint32_t begin = 0, end = 0;  // of order_
    std::uint32_t left = 0;            // its children are left and left + 1; 0: a leaf
    std::uint32_t parent = 0, alive = 0;
  };

  void split(std::uint32_t node);
  double distance_to(const Node& node, const PaperPoint& place) const;
  template <class Visit>
  void visit(const PaperPoint& place, const Visit& visit_end) const;

  std::vector<PaperPoint> points_;
  std::vector<std::uint32_t> order_, leaf_of_;
  std::vector<char> is_out_;
  std::vector<Node> nodes_;
};

}  // namespace hsr::internal
