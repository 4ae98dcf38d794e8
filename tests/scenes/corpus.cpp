#include "tests/scenes/corpus.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace hsr::scenes {

std::vector<std::filesystem::path> corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TestScene scene_from_file(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return scene_from_text(text.str());
}

}  // namespace hsr::scenes
