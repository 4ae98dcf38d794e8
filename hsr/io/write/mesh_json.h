#pragma once

#include <string>

#include "geometry/mesh.h"
#include "hsr/io/write/json.h"

namespace hsr::internal {

/// The faces as used, as JSON, "hsr-mesh/1" (docs/conventions.md, "JSON"): the points as given (-0 is 0), each face with its
/// triangles, and the diagonals of those that are cut into triangles; the faces that were dropped, and why.
std::string mesh_json(const Mesh& mesh, Numbers numbers = Numbers::rounded);

}  // namespace hsr::internal
