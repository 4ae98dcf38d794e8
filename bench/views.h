#pragma once

#include <string>

#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// The views of the benchmarks by their names. oblique: from above, in a direction that is no multiple of anything; elevation:
/// from the front; perspective: from the oblique direction, two diagonals of the bounding box away from its centre.
/// @throws InputError for another name
View view_of(const std::string& name, const Mesh& mesh);

}  // namespace hsr::bench
