#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// The vertices as a parallel view sees them: to the right, up, and toward the viewer, scaled and moved into [0, size]^3. In
/// doubles: what peers are handed.
/// @throws PreconditionError in perspective
std::vector<std::array<double, 3>> seen_points(const Mesh& mesh, const View& view, double size);

}  // namespace hsr::bench
