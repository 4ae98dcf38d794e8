// The tiles of the page on culling are where they are in the picture, and what hides is as deep as they say.
#include <catch2/catch.hpp>
#include <cmath>

#include "study/explain/example_scenes.h"
#include "study/explain/explained_methods.h"
#include "tests/study/traces.h"

namespace hsr::internal {
namespace {

using Place = std::array<double, 2>;

bool is_inside(const Json& ring, const Place& p, double slack) {
  int sides[2] = {0, 0};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Json &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const double dx = b[0].get<double>() - a[0].get<double>(), dy = b[1].get<double>() - a[1].get<double>();
    const double turn = dx * (p[1] - a[1].get<double>()) - dy * (p[0] - a[0].get<double>());
    if (turn < -slack * std::hypot(dx, dy)) ++sides[0];
    if (turn > slack * std::hypot(dx, dy)) ++sides[1];
  }
  return sides[0] == 0 || sides[1] == 0;
}

TEST_CASE("tiles are shown where the faces are that cover them", "[study][explain]") {
  for (const View& view : {parallel_view({0, 0, 1}, {0, 1, 0}, {5, 5, 0}), parallel_view({1, -2, 4}, {0, 0, 1}, {5, 5, 0}),
                           perspective_view({3, -4, 25}, {4, 5, 0}, {0, 1, 0})}) {
    ExplainedScene scene = example_scene("yard");
    scene.view = view;
    const Json trace = Json::parse(trace_json(explain_culling(scene, 16)));
    const Json& run = trace["runs"][5];
    REQUIRE(run["name"] == "occlusion");
    const Json& tiles = run["steps"][1]["changes"][0];
    REQUIRE(tiles["do"] == "tiles");
    const int columns = tiles["columns"], rows = tiles["rows"];
    REQUIRE(tiles["depths"].size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto at = [&](double i, double j, std::size_t k) {
      return tiles["corner"][k].get<double>() + i * tiles["column"][k].get<double>() + j * tiles["row"][k].get<double>();
    };
    int covered = 0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        if (tiles["depths"][static_cast<std::size_t>(j * columns + i)].is_null()) continue;
        ++covered;
        bool is_covered = false;
        for (const Json& face : trace["scene"]["faces"]) {
          bool all = true;
          for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            all = all && is_inside(face["rings"][0], {at(i + x, j + y, 0), at(i + x, j + y, 1)}, 0.1);
          is_covered = is_covered || all;
        }
        CHECK(is_covered);
      }
    CHECK(covered > 100);
    CHECK(run["steps"][1]["numbers"][1] == Json({"of these, covered", covered}));
  }
}

TEST_CASE("what each triangle touches says why it is culled", "[study][explain]") {
  const Json trace = Json::parse(trace_json(explain_culling(example_scene("yard"), 16)));
  int culled = 0;
  for (const Json& step : trace["runs"][5]["steps"]) {
    if (!step.contains("tiles")) continue;
    bool is_hidden = true;
    for (const Json& tile : step["tiles"]) is_hidden = is_hidden && tile[2].get<bool>();
    CHECK(is_hidden == (step["kind"] == "culled"));
    culled += is_hidden ? 1 : 0;
  }
  CHECK(culled == 2);
}

}  // namespace
}  // namespace hsr::internal
