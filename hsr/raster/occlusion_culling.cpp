#include "hsr/raster/occlusion_culling.h"

#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

Culled occlusion_culled(const SceneView& scene, CullingObserver* observer) {
  const Mesh& mesh = scene.mesh();
  const OcclusionPyramid pyramid(scene.parts().projected(), true);
  std::vector<std::uint8_t> hidden(mesh.triangles.size(), 0);
  if (!pyramid.is_empty()) pyramid.mark_hidden(hidden);
  if (observer != nullptr) observer->covered(scene.parts().projected(), pyramid.grid());
  Culled result;
  result.tests = pyramid.is_empty() ? 0 : hidden.size();
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    if (observer != nullptr) {
      const std::vector<OcclusionPyramid::TouchedTile> tiles = pyramid.touched(TriangleId(k));
      observer->tested({.first = k, .end = k + 1, .is_culled = hidden[k] != 0, .tiles = tiles});
    }
    if (hidden[k] == 0)
      result.kept.push_back(TriangleId(k));
    else
      ++result.culled;
  }
  return result;
}

}  // namespace hsr::internal
