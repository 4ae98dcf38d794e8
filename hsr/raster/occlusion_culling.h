#pragma once

#include "hsr/raster/culled.h"
#include "hsr/raster/culling_observer.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// The triangles that are not certainly hidden: a tile of the image that a near triangle, or two that share an edge, cover has
/// a depth beyond which nothing is seen, a coarser tile the farthest of those of its parts; what lies behind in all tiles that
/// it touches is culled. The tiles are those that lines and fragments leave out hidden faces by.
///
///   (1) no picture of an exact method changes, and of the others none but where rounding drew what is hidden
///
/// @param observer is told each test; null: nobody is
/// Exact: conservative; all bounds are rounded toward "seen". Cost: O(n + tiles covered), parallel.
/// Source: Greene, Kass & Miller 1993, "Hierarchical Z-buffer visibility".
Culled occlusion_culled(const SceneView& scene, CullingObserver* observer = nullptr);
/// Of a scene that nothing else looks at.
inline Culled occlusion_culled(const Mesh& mesh, const View& view) { return occlusion_culled(SceneView(mesh, view)); }

}  // namespace hsr::internal
