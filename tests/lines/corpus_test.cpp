#include "tests/scenes/corpus.h"

#include <catch2/catch.hpp>

#include "tests/lines/checked_lines.h"

namespace hsr {
namespace {

TEST_CASE("both methods agree with the oracle on every scene of the corpus", "[lines][oracle][corpus]") {
  const auto files = scenes::corpus(HSR_CORPUS);
  CHECK_FALSE(files.empty());
  for (const auto& file : files) {
    DYNAMIC_SECTION(file.filename().string()) {
      const scenes::TestScene scene = scenes::scene_from_file(file);
      LineOptions options = all_edges();
      CHECK(wrong_with(scene, options) == "");
      options.why = true;
      CHECK(wrong_with(scene, options) == "");
    }
  }
}

}  // namespace
}  // namespace hsr
