// What a section takes away, against the oracles: planes that cut at places that no double holds, and scenes that no cap covers.
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <string>

#include "geometry/error.h"
#include "hsr/lines/hidden_points.h"
#include "hsr/surfaces/section.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/lines/checked_lines.h"
#include "tests/oracle/surfaces_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

/// A plane through some of the scene's points, near them, or anywhere; nothing: there is none that can be looked at.
std::optional<View> any_section(const scenes::TestScene& scene, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 7);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  if (scene.points.empty()) return {};
  const auto some = [&] { return scene.points[random() % scene.points.size()]; };
  const Point3 a = some(), b = some();
  const Point3 point = between(0, 1) == 0 ? a : Point3{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  Point3 normal = {static_cast<double>(between(-3, 3)), static_cast<double>(between(-3, 3)),
                   static_cast<double>(between(-3, 3))};
  if (between(0, 2) == 0) normal = {normal.x + 1.0 / 3, normal.y * 1.1, normal.z - 1.0 / 7};
  try {
    return with_section(scene.view, point, normal);
  } catch (const InputError&) {
    return {};
  }
}

template <class Wrong>
void check_families(std::initializer_list<const char*> families, std::uint64_t count, const Wrong& wrong) {
  for (const char* name : families) {
    int checked = 0;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
      scenes::TestScene scene = scenes::family(name).make(seed);
      const auto view = any_section(scene, seed);
      if (!view) continue;
      scene.view = *view;
      try {
        const Mesh mesh = scene.mesh();
        if (!section(SceneView(mesh, scene.view)).caps.empty()) continue;
      } catch (const InputError&) {
        continue;  // a perspective whose near plane cuts
      }
      ++checked;
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      CHECK(wrong(scene) == "");
    }
    INFO(name);
    CHECK(checked > static_cast<int>(count / 5));
  }
}

TEST_CASE("lines of what a section leaves agree with the oracle", "[section][oracle]") {
  check_families({"triangles", "polygons", "edge_on", "slopes", "echoes", "far_away", "scaled", "magnitudes"}, 200,
                 [](const scenes::TestScene& scene) { return wrong_with(scene); });
}

TEST_CASE("fragments of what a section leaves agree with the oracle", "[section][oracle]") {
  check_families({"triangles", "polygons", "edge_on", "slopes", "echoes"}, 100, [](const scenes::TestScene& scene) {
    const Mesh mesh = scene.mesh();
    const oracle::SurfacesOracle oracle(mesh, scene.view);
    std::string all;
    for (const std::string& text : oracle.differences(visible_fragments(SceneView(mesh, scene.view)))) all += text + "\n";
    return all;
  });
}

/// The visible parts of all lines, in space.
std::set<std::string> visible_parts(const Mesh& mesh, const View& view) {
  const SceneView scene(mesh, view);
  const VisibleLines lines = visible_lines(scene);
  std::set<std::string> all;
  for (const Line& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      std::array<std::string, 2> ends;
      for (std::uint32_t e = 0; e < 2; ++e)
        for (const Rational& x : exact_point(scene, lines, line, k + e)) ends[e] += x.to_string() + " ";
      all.insert(std::min(ends[0], ends[1]) + std::max(ends[0], ends[1]));
    }
  return all;
}

TEST_CASE("what a section takes away may be before the near plane, and behind the eye", "[section][X1]") {
  const auto box = [](double top) {
    scenes::TestScene scene;
    scene.add_box({0, 0, 0}, {4, 4, top});
    scene.add_box({1, 1, -2}, {9, 3, -1});
    return scene.mesh();
  };
  const Mesh low = box(2.5), high = box(8);
  const auto view = [](double near) {
    return with_section(perspective_view({2, 1.5, 4}, {2, 2, 0}, {0, 1, 0}, near), {0, 0, 2}, {0.125, 0, 1});
  };
  const std::set<std::string> expected = visible_parts(low, view(0.125));
  CHECK(expected.size() == 3);  // of the second box beside the cap
  CHECK(visible_parts(high, view(0.125)) == expected);
  CHECK(visible_parts(low, view(1.75)) == expected);
  CHECK(visible_parts(high, view(1.75)) == expected);
  // Here some of what the section leaves is before the near plane.
  CHECK_THROWS_AS(visible_parts(high, view(2.5)), InputError);
  CHECK_THROWS_AS(visible_parts(low, view(2.5)), InputError);
}

TEST_CASE("points behind a cap are hidden, and those in its plane, too", "[section][X2][X5]") {
  scenes::TestScene scene;
  scene.add_box({0, 0, 0}, {2, 2, 2});
  const Mesh mesh = scene.mesh();
  const SceneView cut(mesh, with_section(scenes::from_direction({0, 0, 1}), {0, 0, 1}, {0, 0, 1}));
  // Inside and below; in the plane, inside, on the border and beside; before the plane.
  CHECK(hidden_points(cut, std::array<Point3, 6>{{{1, 1, 0.5}, {1, 1, -3}, {1, 1, 1}, {2, 1, 1}, {3, 1, 1}, {1, 1, 1.5}}}) ==
        std::vector<bool>{true, true, true, true, false, false});
}

}  // namespace
}  // namespace hsr
