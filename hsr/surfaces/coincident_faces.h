#pragma once

#include <cstdint>
#include <vector>

#include "hsr/scene/scene.h"

namespace hsr::internal {

/// Which coincident faces count.
enum class Coincidence : unsigned char {
  seen,  ///< where nothing hides the place in which they coincide
  all,   ///< wherever they are: behind transparent faces, too
};

/// The faces, ascending, that have a part of some area under a face of another kind which coincides with them there: what the rule
/// for coincident faces (TieRule) decides to the eye. Faces that are seen edge-on are not looked at.
///
/// @param kind of each face: faces of one kind look alike
/// Exact: yes. Cost: of pairs of triangles that touch and are of two kinds, a sign each; a cut and the shadows in front for each
/// pair in one plane; parallel. Nothing, where all faces are of one kind.
std::vector<FaceId> under_coincident_faces(const SceneView& scene, const std::vector<std::uint32_t>& kind, Coincidence which);

}  // namespace hsr::internal
