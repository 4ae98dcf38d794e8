#include <catch2/catch.hpp>
#include <exception>

#include "geometry/error.h"
#include "hsr/check/order_check.h"
#include "hsr/painter/bsp.h"
#include "hsr/painter/depth_sort.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/scenes/corpus.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

/// Samples at which the painting shows another face than the nearest.
std::string wrong_samples(const Mesh& mesh, const View& view, const PaintersOrder& order) {
  try {
    const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 24, 24);
    const OrderCheck check = check_order(mesh, view, order, grid);
    return check.wrong == 0 ? "" : std::to_string(check.wrong) + " samples show another face\n";
  } catch (const PreconditionError&) {
    return "";  // the eye in the plane of the samples, or samples that are no doubles
  } catch (const InputError&) {
    return "";  // a picture beyond all doubles
  }
}

std::string wrong_order(const scenes::TestScene& scene) {
  try {
    const Mesh mesh = scene.mesh();
    std::string wrong;
    const auto check = [&](const char* method, const PaintersOrder& order) {
      for (const std::string& w : oracle::wrong_with_order(mesh, scene.view, order))
        wrong.append(method).append(": ").append(w).append("\n");
      wrong += wrong_samples(mesh, scene.view, order);
    };
    check("depth sort", depth_sort(mesh, scene.view).order);
    DepthSortOptions classic;
    classic.classic = true;
    check("classic depth sort", depth_sort(mesh, scene.view, classic).order);
    check("bsp", BspTree(mesh).order(scene.view));
    return wrong;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

void agrees_on(const scenes::Family& family, std::uint64_t first, int count) {
  int failures = 0;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count) && failures < 3; ++seed) {
    scenes::TestScene scene = family.make(seed);
    scene.name = std::string(family.name) + " " + std::to_string(seed);
    if (wrong_order(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [](const scenes::TestScene& s) { return !wrong_order(s).empty(); });
    FAIL_CHECK("For tests/corpus:\n" << scenes::to_text(scene) << wrong_order(scene));
  }
  CHECK(failures == 0);
}

TEST_CASE("every pair of pieces is in order, by each method, on every family of scenes", "[painter][oracle]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 0, 60); }
  }
}

TEST_CASE("every pair of pieces is in order on every scene of the corpus", "[painter][oracle][corpus]") {
  for (const auto& file : scenes::corpus(HSR_CORPUS)) {
    DYNAMIC_SECTION(file.filename().string()) { CHECK(wrong_order(scenes::scene_from_file(file)) == ""); }
  }
}

TEST_CASE("every pair of pieces is in order on many more random scenes", "[painter][oracle][long]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 1'000'000, 10'000); }
  }
}

}  // namespace
}  // namespace hsr
