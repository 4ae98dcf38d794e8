#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/lines/checked_lines.h"

namespace hsr {
namespace {

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(HSR_CORPUS))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST_CASE("both methods agree with the oracle on every scene of the corpus", "[lines][oracle][corpus]") {
  const auto files = corpus();
  CHECK_FALSE(files.empty());
  for (const auto& file : files) {
    DYNAMIC_SECTION(file.filename().string()) {
      std::ostringstream text;
      text << std::ifstream(file).rdbuf();
      const scenes::TestScene scene = scenes::scene_from_text(text.str());
      LineOptions options = all_edges();
      CHECK(wrong_with(scene, options) == "");
      options.why = true;
      CHECK(wrong_with(scene, options) == "");
    }
  }
}

}  // namespace
}  // namespace hsr
