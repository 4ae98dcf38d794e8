#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "hsr/face_labels.h"

namespace hsr::internal {

/// The circles that edges of a mesh are marked to lie on.
class MarkedCircles {
 public:
  MarkedCircles() = default;
  /// @param labels what the mesh's faces and edges belong to @pre its marks name points of the mesh, as those of a Scene do
  MarkedCircles(const Mesh& mesh, const FaceLabels& labels);

  bool is_empty() const { return rows_.empty(); }
  /// The circle of the edge between two vertices, in any order; the first mark with one counts. nullptr: none is known.
  /// Cost: O(log n).
  const KnownCircle* of(VertexId a, VertexId b) const;

 private:
  struct Row {
    VertexId a, b;  // a < b
    const KnownCircle* circle = nullptr;
  };
  std::vector<Row> rows_;  // ascending by a and b, each pair once
};

}  // namespace hsr::internal
