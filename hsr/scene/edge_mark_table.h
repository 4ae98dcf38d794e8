#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/edge_marks.h"

namespace hsr::internal {

/// The mark of an edge, and of which object's faces it is.
struct MarkOfObject {
  EdgeMark mark = EdgeMark::inner;
  std::uint32_t object = 0;

  friend bool operator==(const MarkOfObject&, const MarkOfObject&) = default;
};

/// Marks by edge. Of one edge and object the strongest counts: sharp, then smooth, then inner.
class EdgeMarkTable {
 public:
  EdgeMarkTable() = default;
  /// @throws InputError if a mark names a point that is not there
  EdgeMarkTable(const Mesh& mesh, const std::vector<MarkedEdge>& marks);

  bool is_empty() const { return ends_.empty(); }
  /// Those of an edge between two vertices, in any order. Cost: O(log n).
  std::span<const MarkOfObject> of(VertexId a, VertexId b) const;

 private:
  struct Ends {
    VertexId a, b;  // a < b
    friend auto operator<=>(const Ends&, const Ends&) = default;
  };
  std::vector<Ends> ends_;  // ascending; entry k has marks_[k]
  std::vector<MarkOfObject> marks_;
};

}  // namespace hsr::internal
