#include "tests/scenes/corpus.h"

#include <catch2/catch.hpp>

#include "tests/surfaces/checked_surfaces.h"

namespace hsr {
namespace {

TEST_CASE("fragments by both methods agree with the oracle on every scene of the corpus", "[surfaces][oracle][corpus]") {
  const auto files = scenes::corpus(HSR_CORPUS);
  CHECK_FALSE(files.empty());
  for (const auto& file : files) {
    DYNAMIC_SECTION(file.filename().string()) { CHECK(wrong_fragments(scenes::scene_from_file(file)) == ""); }
  }
}

}  // namespace
}  // namespace hsr
