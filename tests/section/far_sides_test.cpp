// Far sides of bodies that a section cuts are left out where a cap covers the cut. Leaving out changes nothing.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <sstream>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/view_parts.h"
#include "tests/scenes/test_scene.h"
#include "tests/section/cut_boxes.h"

namespace hsr {
namespace {

using namespace internal;

/// What is visible and what is hidden of each line.
std::string text_of(const SceneView& scene, const VisibleLines& lines) {
  std::vector<std::string> all;
  for (const Line& line : lines.lines) {
    if (line.is_intersection()) continue;
    std::ostringstream text;
    text << line.edge.value << " " << static_cast<int>(line.edge_class) << ":";
    const SupportingLine support = supporting_line_of(scene.mesh(), lines, line);
    for (const Cut& cut : lines.cuts_of(line))
      text << " " << exact_parameter(scene.mesh(), scene.view(), support, cut).to_string();
    text << (line.intervals() > 0 && line.hidden(0) ? " hidden first\n" : "\n");
    all.push_back(text.str());
  }
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& line : all) text += line;
  return text;
}

SceneView scene_of(const CutBoxes& boxes, When far_sides, When tiles) {
  SceneOptions options;
  options.when(Stage::back_faces) = options.when(Stage::convex_body) = far_sides;
  options.when(Stage::hidden_tiles) = tiles;
  return SceneView(Scene(make_mesh(boxes.points, boxes.polygons), boxes.labels), boxes.view, options);
}

/// As one object, and every second box turned inside out if `has_cavities`.
CutBoxes in_one_object(CutBoxes boxes, bool has_cavities) {
  for (std::size_t f = 0; f < boxes.polygons.size(); ++f) {
    if (has_cavities && boxes.labels.object[f] % 2 == 1)
      std::reverse(boxes.polygons.corners.begin() + boxes.polygons.first[f],
                   boxes.polygons.corners.begin() + boxes.polygons.first[f + 1]);
  }
  std::fill(boxes.labels.object.begin(), boxes.labels.object.end(), 0);
  return boxes;
}

TEST_CASE("far sides of bodies that a section cuts hide nothing that caps do not", "[section][X5]") {
  std::size_t left_out = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const CutBoxes apart = cut_boxes(seed);
    for (const CutBoxes& boxes : {apart, in_one_object(apart, false), in_one_object(apart, true)}) {
      INFO("seed " << seed << "\n" << boxes.text);
      LineOptions options;
      options.classes.fill(true);
      const SceneView whole = scene_of(boxes, When::never, When::never);
      const std::string expected = text_of(whole, visible_lines(whole, options));
      for (const When tiles : {When::never, When::always}) {
        const SceneView scene = scene_of(boxes, When::automatic, tiles);
        for (const LineMethod method : {LineMethod::roberts, LineMethod::appel}) {
          options.method = method;
          CHECK(text_of(scene, visible_lines(scene, options)) == expected);
        }
        left_out += scene.parts().bodies_with_caps()->count() - scene.parts().bodies()->count();
      }
    }
  }
  CHECK(left_out > 300);
}

TEST_CASE("what tiles hide of an edge ends where a shadow does, in a section, too", "[section][X5]") {
  scenes::TestScene town;
  std::mt19937 random(1);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 10; ++k) {
      const double x = 16 * k + between(0, 5), y = 17 * i, z = between(5, 60);
      town.add_box({x, y, 0}, {x + between(4, 10), y + between(4, 12), z});
    }
  // Of triangles: the diagonals of walls run aslant.
  Polygons triangles;
  for (std::size_t f = 0; f < town.polygons.size(); ++f)
    for (const auto& t : {std::array{0, 1, 2}, {0, 2, 3}}) {
      for (const int c : t) triangles.corners.push_back(town.polygons[f][static_cast<std::size_t>(c)]);
      triangles.first.push_back(static_cast<std::uint32_t>(triangles.corners.size()));
    }
  const Mesh mesh = make_mesh(town.points, triangles);
  const View view = with_section(scenes::from_direction({0, -1, 0}), {0, 0.5, 0}, {0, 1, 0});
  std::string expected;
  for (const When stage : {When::never, When::always}) {
    SceneOptions scene_options;
    scene_options.when(Stage::back_faces) = scene_options.when(Stage::hidden_tiles) = stage;
    const SceneView scene(Scene(mesh, FaceLabels()), view, scene_options);
    for (const LineMethod method : {LineMethod::roberts, LineMethod::appel}) {
      LineOptions options;
      options.method = method;
      options.classes.fill(true);
      const std::string found = text_of(scene, visible_lines(scene, options));
      if (expected.empty()) expected = found;
      CHECK(found == expected);
    }
  }
}

}  // namespace
}  // namespace hsr
