#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "hsr/model.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// The colour of each face: the file's, or where it has none a grey that is lighter the more the face is turned to a light at
/// the upper left of the viewer. For the eye: computed in doubles.
std::vector<Colour> face_colours(const Model& model, const Mesh& mesh, const View& view);

}  // namespace hsr::internal
