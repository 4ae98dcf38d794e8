#pragma once

#include <cstddef>
#include <span>

#include "hsr/scene/occlusion_pyramid.h"

namespace hsr::internal {

/// Why some triangles that follow one another are culled, or kept.
struct CullingTest {
  std::size_t first, end;  ///< triangles
  bool is_culled;
  /// Facing: the number whose sign tells front (positive) from back. Importance: how many samples it is wide or high, the larger.
  double value = 0;
  /// Frustum: the side beyond which it is: above, right of, below, left of the picture; 4: before the near plane; -1: none.
  int side = -1;
  /// Occlusion: the tiles that the triangle touches. It is culled if all triangles of its face are hidden in all of theirs.
  std::span<const OcclusionPyramid::TouchedTile> tiles = {};
};

/// Is told each test of a culling, in the order in which they are made.
class CullingObserver {
 public:
  CullingObserver() = default;
  CullingObserver(const CullingObserver&) = delete;
  CullingObserver& operator=(const CullingObserver&) = delete;
  virtual ~CullingObserver() = default;

  /// Occlusion: the tiles are covered, and the tests begin.
  virtual void covered(const ProjectedMesh& /*projected*/, const OcclusionPyramid::Grid& /*tiles*/) {}
  virtual void tested(const CullingTest& test) = 0;
};

}  // namespace hsr::internal
