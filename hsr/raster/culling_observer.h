#pragma once

#include <cstddef>

namespace hsr::internal {

/// Why some triangles that follow one another are culled, or kept.
struct CullingTest {
  std::size_t first, end;  ///< triangles
  bool is_culled;
  /// Facing: the number whose sign tells front (positive) from back. Importance: how many samples it is wide or high, the larger.
  double value = 0;
  /// Frustum: the side beyond which it is: above, right of, below, left of the picture; 4: before the near plane; -1: none.
  int side = -1;
};

/// Is told each test of a culling, in the order in which they are made.
class CullingObserver {
 public:
  CullingObserver() = default;
  CullingObserver(const CullingObserver&) = delete;
  CullingObserver& operator=(const CullingObserver&) = delete;
  virtual ~CullingObserver() = default;

  virtual void tested(const CullingTest& test) = 0;
};

}  // namespace hsr::internal
