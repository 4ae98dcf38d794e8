#pragma once

#include <cstddef>

#include "hsr/raster/culled.h"
#include "hsr/raster/culling_observer.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What bounds some triangles.
enum class Bounds : std::uint8_t {
  boxes,   ///< along the axes: tight for most, eight corners to test
  spheres  ///< around the middle of the box: one distance to test
};

struct FrustumOptions {
  Bounds bounds = Bounds::boxes;
  std::size_t block = 64;  ///< so many triangles that follow one another are bounded together
};

/// The triangles that are not certainly out of the picture: their bounds lie wholly beyond one of its four sides, a sample off
/// so that rounding cannot draw them, or that the near plane cuts away.
///
///   (1) no picture changes, of any method
///   (2) where doubles cannot tell, triangles are kept
///
/// @param observer is told each test; null: nobody is
/// Exact: conservative. Cost: O(n).
/// Source: Clark 1976; Assarsson & Möller 2000.
Culled frustum_culled(const Mesh& mesh, const View& view, const SampleGrid& samples, const FrustumOptions& options = {},
                      CullingObserver* observer = nullptr);

}  // namespace hsr::internal
