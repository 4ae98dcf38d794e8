#pragma once

#include <cstdint>
#include <span>

#include "hsr/painter/sort/face_pieces.h"
#include "hsr/painter/sort/z_sort.h"

namespace hsr::internal {

/// Is told how z_sort() orders pieces.
class ZSortObserver {
 public:
  ZSortObserver() = default;
  ZSortObserver(const ZSortObserver&) = delete;
  ZSortObserver& operator=(const ZSortObserver&) = delete;
  virtual ~ZSortObserver() = default;

  virtual void began(const FacePieces& pieces) = 0;
  /// The number by which a piece is sorted: a depth, in units of its own, that grows away from the viewer.
  virtual void keyed(std::uint32_t piece, double depth) = 0;
  /// From far to near.
  virtual void sorted(std::span<const std::uint32_t> pieces) = 0;
};

/// z_sort(), watched: it does the same and gives the same. @pre the view has no cells
PaintersOrder z_sort(const SceneView& scene, DepthKey key, ZSortObserver& observer);

}  // namespace hsr::internal
