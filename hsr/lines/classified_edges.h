#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr {

class ViewFrustum;

/// How many edges are handled together: fixed, so that counts are the same for any number of threads.
constexpr std::size_t edges_of_block = 512;

/// What of an edge is asked for.
struct RequestedPart {
  EdgeId edge;
  EdgeClass edge_class = EdgeClass::smooth;
  Cut from{Cut::Kind::start}, to{Cut::Kind::end};
};

/// The edges that are asked for, ascending, their classes and boxes. An edge of several classes stands there once for each of
/// its parts. Cost: O(n), parallel.
struct ClassifiedEdges {
  std::vector<EdgeId> edges;
  std::vector<EdgeClass> classes;
  std::vector<ImageBox> boxes;
  std::vector<std::uint8_t> hidden;  ///< provably hidden all along, and no point in the image; empty: not known of any
  DecisionCounts decisions;

  /// @param outside the edges to leave out, or nullptr
  /// @param occluders all triangles, or nullptr @param has_contact by edge: whether it may lie in one of them; empty: none does
  ClassifiedEdges(const ProjectedMesh& projected, const LineOptions& options, const ViewFrustum* outside,
                  const Occluders* occluders, const std::vector<std::uint8_t>& has_contact);
  /// Edges for their own sake: their classes are not looked at.
  ClassifiedEdges(const ProjectedMesh& projected, std::vector<EdgeId> ascending);

  /// Whether only a part of edge i of the list is asked for.
  bool is_part(std::size_t i) const;
  RequestedPart operator[](std::size_t i) const;

 private:
  struct Part {
    std::size_t index;
    Cut from, to;
  };
  const Part* part(std::size_t i) const;
  void find_boxes(const ProjectedMesh& projected);

  std::vector<Part> parts_;  // ascending; edges that are not in it are asked for from end to end
};

}  // namespace hsr
