#pragma once

#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "study/explain/trace.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// Where the tiles of a scene are in the picture, and how deep is what they hide, as ScenePicture has it.
TraceTiles traced_tiles(const ScenePicture& picture, const ProjectedMesh& projected, const OcclusionPyramid::Grid& grid);

}  // namespace hsr::internal
