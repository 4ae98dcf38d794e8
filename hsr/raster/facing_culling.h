#pragma once

#include "geometry/number.h"
#include "hsr/raster/culled.h"
#include "hsr/raster/culling_observer.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// Where the sign is computed that tells front from back.
enum class FacingSpace : std::uint8_t {
  world,      ///< the normal against the way to the viewer
  eye,        ///< the same where the viewer is at the origin, and axes are those of the picture
  projection  ///< the area of the triangle as it is seen, in homogeneous coordinates
};

/// Positive: the corners turn counter-clockwise as the viewer sees them, the front. Zero: seen edge-on.
/// Exact: yes, in each space; all three agree. Source: for the projection without a division, Olano & Greer 1997.
Sign facing(const Mesh& mesh, const View& view, TriangleId t, FacingSpace space = FacingSpace::world);

enum class Facing : std::uint8_t { back, front };

/// The triangles without those that face the other way, or are seen edge-on.
///
/// Without back faces the picture of closed, outward bodies does not change while the viewer is outside; of other models it
/// may. @param observer is told each test; null: nobody is
/// Exact: yes. Cost: O(n). Source: Foley, van Dam, Feiner & Hughes 1990, "back-face culling".
Culled facing_culled(const Mesh& mesh, const View& view, Facing culled = Facing::back, FacingSpace space = FacingSpace::world,
                     CullingObserver* observer = nullptr);

}  // namespace hsr::internal
