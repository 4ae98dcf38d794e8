#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/oracle/surfaces_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

// HSR_TEST_SCENES=10 tests ten times as many scenes.
double more_scenes() {
  const char* text = std::getenv("HSR_TEST_SCENES");
  return text == nullptr ? 1 : std::strtod(text, nullptr);
}

std::string wrong_with(const scenes::TestScene& scene) {
  try {
    const Mesh mesh = scene.mesh();
    const oracle::SurfacesOracle truth(mesh, scene.view);
    std::string wrong;
    for (const std::string& line : truth.differences(roberts_surfaces(mesh, scene.view))) wrong += "roberts: " + line + "\n";
    for (const std::string& line : truth.differences(visible_fragments(mesh, scene.view))) wrong += "fragments: " + line + "\n";
    return wrong;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

void agrees_on(const std::string& name, std::uint64_t first_seed, int count) {
  const scenes::Family& family = scenes::family(name);
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 3; ++seed) {
    scenes::TestScene scene = family.make(seed);
    scene.name = name + " " + std::to_string(seed);
    if (wrong_with(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong_with(s).empty(); });
    FAIL_CHECK("For tests/surfaces/corpus:\n" << scenes::to_text(scene) << wrong_with(scene));
  }
  CHECK(failures == 0);
}

TEST_CASE("fragments agree with the oracle on every family of scenes", "[surfaces][oracle]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family.name, 0, 40); }
  }
}

}  // namespace
}  // namespace hsr
