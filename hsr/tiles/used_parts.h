#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/tiles/model_part.h"

namespace hsr::internal {

/// Which faces, wires and points of a tile its pieces name.
class UsedParts {
 public:
  /// @param part of the tile; outlives this
  explicit UsedParts(const ModelPart& part) : part_(part), faces_(part.faces.size(), 0), points_(part.points.size(), 0) {}

  void add(TriangleId t, const Mesh& mesh) { faces_[mesh.face_of[t].value] = 1; }
  void add(VertexId v) { points_[v.value] = 1; }
  void add_wires_along(const Edge& e) { wires_.push_back({e.a.value, e.b.value}); }
  /// Of the tile what was added. @param mesh of the tile
  ModelPart part(const Mesh& mesh);

 private:
  const ModelPart& part_;
  std::vector<char> faces_, points_;
  std::vector<std::array<std::uint32_t, 2>> wires_;
};

}  // namespace hsr::internal
