#pragma once

#include <filesystem>
#include <vector>

#include "tests/scenes/test_scene.h"

namespace hsr::scenes {

/// The scenes of a folder, by name: each showed a mistake once, or what is easily mistaken.
std::vector<std::filesystem::path> corpus(const std::filesystem::path& folder);
TestScene scene_from_file(const std::filesystem::path& file);

}  // namespace hsr::scenes
