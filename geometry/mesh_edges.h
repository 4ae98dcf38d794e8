#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::internal {

/// Fills the edges and sides of a mesh whose points, merged vertices, faces and triangles are there.
///
/// @param ring_sides per triangle: bit k, the side from corner k to corner k + 1 is in the ring of its face
/// @throws InputError if there are 2^30 - 1 triangles or more, or 2^32 - 1 sides of triangles and segments. Cost: O(n), a
/// counting sort by the lower vertex.
void connect_edges(Mesh& mesh, const std::vector<std::uint8_t>& ring_sides,
                   std::span<const std::array<std::uint32_t, 2>> segments,
                   std::span<const std::array<std::uint32_t, 2>> edges_of_ghosts = {});

}  // namespace hsr::internal
