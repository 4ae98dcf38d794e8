#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/model.h"
#include "hsr/view/view.h"

namespace hsr::internal {

enum class Shading : std::uint8_t { none, slope };

/// The colour of each face: the file's, or light grey. By slope: darker the less the face is turned to a light at the upper left
/// of the viewer. For the eye: computed in doubles.
std::vector<Colour> face_colours(const Model& model, const Mesh& mesh, const View& view, Shading shading = Shading::slope);

}  // namespace hsr::internal
