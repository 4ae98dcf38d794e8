#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "hsr/lines/line_options.h"
#include "hsr/lines/occluders.h"
#include "hsr/lines/shadows.h"
#include "hsr/lines/visible_lines.h"

namespace hsr {

/// Sorts the shadows of one edge at a time along it, and of these makes the hidden and visible intervals. One object for each
/// block of edges.
class Tiling {
 public:
  Tiling(const Sight& sight, const LineOptions& options) : options_(options), shadows_(sight) {}

  /// The edge as all the triangles that overlap it in the image leave it.
  void add_by_casting(EdgeId edge, EdgeClass edge_class, const ImageBox& box, const Occluders& occluders);
  /// The edge with these shadows, which are sorted and united here. @pre shadows().start(edge) was true
  void add(EdgeId edge, EdgeClass edge_class, std::vector<Shadow>& shadows);
  /// An edge wholly beyond the near plane that is hidden, or visible, all along.
  void add_whole(EdgeId edge, EdgeClass edge_class, bool is_hidden);
  /// An edge without parts: seen as a point, or before the near plane.
  void add_nothing(EdgeId edge, EdgeClass edge_class);

  Shadows& shadows() { return shadows_; }
  Predicates& exact() { return shadows_.exact(); }
  std::uint64_t& pairs() { return result_.pairs; }
  VisibleLines take() {
    result_.decisions = exact().counts();
    return std::move(result_);
  }

 private:
  void unite(std::vector<Shadow>& cast);
  void check_ascending(std::span<const Shadow> hidden);
  void sort_by_face();
  void name_occluders(std::span<const Shadow> hidden, std::span<const Shadow> by_face);
  LineOfEdge begun(EdgeId edge, EdgeClass edge_class) const;
  void end(LineOfEdge line);

  const LineOptions& options_;
  Shadows shadows_;
  std::vector<Shadow> cast_, by_face_, one_face_;
  VisibleLines result_;
};

/// The lines of edges that do not depend on one another, in blocks in parallel. @param order the edges to tile, near ones near
/// @param add tiles one of them
VisibleLines tiled_in_blocks(const Sight& sight, const LineOptions& options, std::span<const std::uint32_t> order,
                             const std::function<void(Tiling&, std::uint32_t)>& add);

/// The lines of all parts in the order of their edges. @param place where each edge's line is: part, and line in it
/// @throws InputError beyond 2^32 - 1 interval ends
VisibleLines joined(const std::vector<VisibleLines>& parts, const std::vector<std::array<std::uint32_t, 2>>& place);

}  // namespace hsr
