#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <sstream>
#include <vector>

#include "tests/lines/labelled_scene.h"
#include "tests/oracle/exact_vector.h"
#include "tests/oracle/seen_edges.h"
#include "tests/scenes/random_scenes.h"

// What touches a single sheet from behind is dashed as what stands behind it, and makes no line on it.

namespace hsr {

namespace {

using oracle::Q;

/// What is hidden of an ink, whatever its class: by straight line of the image, intervals that are apart.
std::map<std::string, std::vector<std::pair<Q, Q>>> hidden_of(const std::string& ink) {
  std::map<std::string, std::vector<std::pair<Q, Q>>> all;
  std::istringstream in(ink);
  std::string line, key;
  while (std::getline(in, line)) {
    if (!line.starts_with("  ")) {
      key = line;
      continue;
    }
    std::istringstream words(line);
    std::string visibility, edge_class, from, to, end;
    words >> visibility >> edge_class >> from >> to >> end;
    if (visibility != "hidden") continue;
    auto& parts = all[key];
    if (!parts.empty() && parts.back().second == Q(from))
      parts.back().second = Q(end);
    else
      parts.emplace_back(Q(from), Q(end));
  }
  return all;
}

std::string to_text(const std::map<std::string, std::vector<std::pair<Q, Q>>>& hidden) {
  std::string text;
  for (const auto& [line, parts] : hidden)
    for (const auto& [from, to] : parts) text += line + ":\n  " + from.get_str() + " to " + to.get_str() + "\n";
  return text;
}

/// Boxes with disjoint insides of which many end at a height of 4.
std::vector<std::array<Point3, 2>> boxes_below(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<double>(random() % static_cast<std::uint64_t>(n)); };
  std::vector<std::array<Point3, 2>> boxes;
  for (int tries = 0; tries < 9; ++tries) {
    const Point3 low = {below(5), below(5), below(4)};
    const Point3 high = {low.x + 1 + below(3), low.y + 1 + below(3), random() % 3 == 0 ? low.z + 1 : 4};
    const bool is_free = std::none_of(boxes.begin(), boxes.end(), [&](const auto& b) {
      return low.x < b[1].x && b[0].x < high.x && low.y < b[1].y && b[0].y < high.y && low.z < b[1].z && b[0].z < high.z;
    });
    if (is_free) boxes.push_back({low, high});
  }
  return boxes;
}

const std::vector<View>& views_from_above() {
  static const std::vector<View> all = {scenes::from_direction({1, -1, 1}), scenes::from_direction({-2, 3, 4}),
                                        scenes::from_direction({0, -1, 1}), scenes::from_direction({0, 0, 1}),
                                        scenes::from_eye({17, -19, 30}, {2, 2, 2})};
  return all;
}

/// A sheet that hides all of the boxes, on which they end or a little above.
void check_sheets(std::uint64_t first_seed, std::uint64_t seeds) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    Labelled touching, apart;
    for (Labelled* x : {&touching, &apart}) {
      for (const auto& [low, high] : boxes_below(seed)) x->add_box(low, high);
      const double height = x == &touching ? 4 : 5;
      x->add_face({{-60, -60, height}, {60, -60, height}, {60, 60, height}, {-60, 60, height}});
    }
    for (const View& view : views_from_above()) {
      touching.scene.view = apart.scene.view = view;
      INFO("seed " << seed << "\n" << scenes::to_text(touching.scene));
      CHECK(difference(to_text(hidden_of(touching.ink())), to_text(hidden_of(apart.ink()))) == "");
      CHECK(lines_of(touching, "visible") == lines_of(touching, "visible boundary"));
      CHECK(difference(touching.ink(), recut(touching, with_cut_sides).ink()) == "");
      CHECK(difference(touching.ink(), recut(touching, in_halves).ink()) == "");
    }
  }
}

TEST_CASE("what touches a sheet from behind is dashed as what stands behind it", "[lines][metamorphic][shape][C17][C19]") {
  check_sheets(780'000, 40);
}

TEST_CASE("what is behind two sheets that meet is one line behind both", "[lines][shape][oracle][C17][C19]") {
  Labelled x;
  x.add_face({{0, 0, 0}, {4, 0, 0}, {4, 8, 0}, {0, 8, 0}}, 1);
  x.add_face({{4, 0, 0}, {10, 0, 0}, {10, 8, 0}, {4, 8, 0}}, 2);
  x.add_box({3, 3, -1}, {6, 5, 0}, 2);
  // The column's head is on top of the sheets: on the second, of its object, its rim is no joint.
  SceneOptions last;
  last.coplanar = Coplanar::last;
  LineOptions options;
  options.classes.fill(true);
  for (const Point3& direction : {Point3{1, -1, 2}, Point3{0, 0, 1}}) {
    const SceneView view(Scene(x.scene.mesh(), x.labels), scenes::from_direction(direction), last);
    const VisibleLines lines = visible_lines(view, options);
    CHECK(oracle::compare_with_oracle(view, lines, options) == std::vector<std::string>{});
    CHECK(std::count_if(lines.lines.begin(), lines.lines.end(), [](const Line& l) { return l.is_behind; }) == 4);
    CHECK(std::count_if(lines.lines.begin(), lines.lines.end(),
                        [](const Line& l) { return !l.is_behind && l.edge_class == EdgeClass::joint; }) > 2);
  }
}

TEST_CASE("much that touches a sheet from behind is dashed as what stands behind it", "[lines][metamorphic][shape][.][long]") {
  check_sheets(790'000, 400);
}

}  // namespace
}  // namespace hsr
