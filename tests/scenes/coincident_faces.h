#pragma once

#include <cstdint>

#include "tests/scenes/test_scene.h"

namespace hsr::scenes {

/// The scene with faces laid upon some of its faces: the same again, turned round or not, a part of it, or one twice as large in
/// its plane; all in shuffled order. Where coordinates are small integers they coincide exactly.
TestScene with_coincident_faces(TestScene scene, std::uint64_t seed);

/// Rectangles with integer corners in three planes, z = 0, 1, 2, many of them upon one another, seen from above; the largest is
/// [0, size] x [0, size].
TestScene sheets(std::uint64_t seed, int size);

/// The scene with its faces listed from the last to the first; points and wires as they are.
TestScene backwards(const TestScene& scene);

}  // namespace hsr::scenes
