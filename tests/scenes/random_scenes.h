#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "tests/scenes/test_scene.h"

namespace hsr::scenes {

/// A way to make small random scenes that love trouble. The same seed gives the same scene everywhere.
struct Family {
  const char* name;
  TestScene (*make)(std::uint64_t seed);
};

/// triangles        integer corners in [-4, 4]^3, shared corners, duplicates, slivers, wires
/// polygons         planar quads, L-shapes, darts, keyholes, bow-ties, non-planar quads
/// edge_on          most faces contain the viewpoint, several share a plane
/// boxes            aligned, touching, sharing walls, seen along an axis or with the eye in the plane of a wall
/// stacks           the same few polygons one subnormal, or one ulp, apart
/// slopes           nearly coplanar faces that cross: slopes of one ulp
/// around_the_eye   the eye among, in or on the faces; near planes that pass through corners
/// echoes           faces, and again exactly behind, so that all of their images coincide
/// far_away         one of the others, moved by up to 2^49
/// scaled           one of the others, everything multiplied by a power of two, up to 2^900 and down to 2^-900
/// magnitudes       numbers from 2^-1074 to 2^1022 side by side
std::span<const Family> families();
/// @throws PreconditionError for another name
const Family& family(const std::string& name);

}  // namespace hsr::scenes
