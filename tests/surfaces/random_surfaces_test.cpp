#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/scenes/random_scenes.h"
#include "tests/surfaces/checked_surfaces.h"

namespace hsr {
namespace {

// HSR_TEST_SCENES=10 tests ten times as many scenes.
double more_scenes() {
  const char* text = std::getenv("HSR_TEST_SCENES");
  return text == nullptr ? 1 : std::strtod(text, nullptr);
}

void agrees_on(const std::string& name, std::uint64_t first_seed, int count) {
  const scenes::Family& family = scenes::family(name);
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 3; ++seed) {
    scenes::TestScene scene = family.make(seed);
    scene.name = name + " " + std::to_string(seed);
    if (wrong_fragments(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong_fragments(s).empty(); });
    FAIL_CHECK("For tests/corpus:\n" << scenes::to_text(scene) << wrong_fragments(scene));
  }
  CHECK(failures == 0);
}

TEST_CASE("fragments by both methods agree with the oracle on every family of scenes", "[surfaces][oracle][S2][S7]") {
  for (const scenes::Family& family : scenes::families()) {
    // "triangles" are soups of small integers, in which everything is degenerate.
    const bool is_soup = std::string(family.name) == "triangles";
    DYNAMIC_SECTION(family.name) { agrees_on(family.name, 0, is_soup ? 200 : 60); }
  }
}

TEST_CASE("fragments by both methods agree with the oracle on many more random scenes", "[surfaces][oracle][long]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family.name, 1'000'000, 10'000); }
  }
}

}  // namespace
}  // namespace hsr
