#pragma once

#include <array>
#include <cstdint>

#include "hsr/painter/painters_order.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr {

struct OrderCheck {
  std::uint64_t samples = 0;
  std::uint64_t covered = 0;                ///< of them, with a face
  std::uint64_t wrong = 0;                  ///< where the painting shows another face than the nearest
  std::array<int, 2> first_wrong = {0, 0};  ///< column and row
};

/// Paints the order and compares each sample with the nearest face along its line of sight, edges and ties included.
///
/// @throws PreconditionError as cast() does
/// Exact: yes. Cost: that of cast() and of painting.
OrderCheck check_order(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples);
/// Of a scene that nothing else looks at.
inline OrderCheck check_order(const Mesh& mesh, const View& view, const PaintersOrder& order, const SampleGrid& samples) {
  return check_order(SceneView(mesh, view), order, samples);
}

}  // namespace hsr
