#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/box_tree.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/sight.h"

namespace hsr {

class OutsideFrame;

/// How many edges are handled together: fixed, so that counts are the same for any number of threads.
constexpr std::size_t edges_of_block = 512;

/// The edges that are asked for, ascending, their classes and boxes. Cost: O(n), parallel.
struct RequestedEdges {
  std::vector<EdgeId> edges;
  std::vector<EdgeClass> classes;
  std::vector<ImageBox> boxes;
  std::vector<std::uint8_t> hidden;  ///< provably hidden all along, and no point in the image; empty: not known of any
  DecisionCounts decisions;

  /// @param outside the edges to leave out, or nullptr
  RequestedEdges(const Sight& sight, const LineOptions& options, const OutsideFrame* outside);
  /// Edges for their own sake: their classes are not looked at.
  RequestedEdges(const Sight& sight, std::vector<EdgeId> ascending);

 private:
  void find_boxes(const Sight& sight);
};

}  // namespace hsr
