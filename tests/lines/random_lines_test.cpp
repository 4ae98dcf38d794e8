#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/lines/checked_lines.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

// HSR_TEST_SCENES=10 tests ten times as many scenes.
double more_scenes() {
  const char* text = std::getenv("HSR_TEST_SCENES");
  return text == nullptr ? 1 : std::strtod(text, nullptr);
}

LineOptions options_for(std::uint64_t seed) {
  LineOptions options = all_edges();
  options.why = seed % 4 == 0;
  options.crease = seed % 5 == 0 ? 80 : 30;
  if (seed % 7 == 0) options.classes = LineOptions{}.classes;
  return options;
}

void agrees_on(const std::string& name, std::uint64_t first_seed, int count) {
  const scenes::Family& family = scenes::family(name);
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 5; ++seed) {
    const LineOptions options = options_for(seed);
    scenes::TestScene scene = family.make(seed);
    scene.name = name + " " + std::to_string(seed);
    if (wrong_with(scene, options).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong_with(s, options).empty(); });
    FAIL_CHECK("For tests/corpus:\n" << scenes::to_text(scene) << wrong_with(scene, options));
  }
  CHECK(failures == 0);
}

TEST_CASE("both methods agree with the oracle on soups of integer triangles", "[lines][oracle][H1]") {
  agrees_on("triangles", 0, 900);
}
TEST_CASE("both methods agree with the oracle on polygons of every shape", "[lines][oracle][H7]") {
  agrees_on("polygons", 0, 400);
}
TEST_CASE("both methods agree with the oracle on faces seen edge-on", "[lines][oracle]") { agrees_on("edge_on", 0, 700); }
TEST_CASE("both methods agree with the oracle on aligned boxes", "[lines][oracle]") { agrees_on("boxes", 0, 150); }
TEST_CASE("both methods agree with the oracle on stacks one subnormal apart", "[lines][oracle]") {
  agrees_on("stacks", 0, 500);
}
TEST_CASE("both methods agree with the oracle on slopes of one ulp", "[lines][oracle]") { agrees_on("slopes", 0, 500); }
TEST_CASE("roberts agrees with the oracle where the eye is among the faces", "[lines][oracle]") {
  agrees_on("around_the_eye", 0, 900);
}
TEST_CASE("both methods agree with the oracle on faces exactly behind one another", "[lines][oracle]") {
  agrees_on("echoes", 0, 600);
}
TEST_CASE("roberts agrees with the oracle far from the origin", "[lines][oracle]") { agrees_on("far_away", 0, 600); }
TEST_CASE("both methods agree with the oracle on scenes scaled by powers of two", "[lines][oracle]") {
  agrees_on("scaled", 0, 400);
}

TEST_CASE("both methods agree with the oracle on numbers from the whole range of doubles", "[lines][oracle][E1]") {
  agrees_on("magnitudes", 0, 400);
}

TEST_CASE("both methods agree with the oracle on many more random scenes", "[lines][oracle][long]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family.name, 1'000'000, 28'000); }
  }
}

}  // namespace
}  // namespace hsr
