#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include "hsr/coordinates/coordinates.h"
#include "hsr/lines/edge_classifier.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/caster.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/lines/checked_lines.h"
#include "tests/oracle/visible_lines_oracle.h"
#include "tests/scenes/random_scenes.h"

// Ghosts: faces whose lines are drawn, and that hide nothing in any stage.

namespace hsr {
namespace {

using oracle::Interval;
using oracle::VisibleLinesOracle;
using scenes::TestScene;

/// Some of the faces as ghosts, the others as they were.
TestScene with_ghosts(TestScene scene, std::uint64_t seed) {
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) scene.polygons.is_ghost.push_back((f * 7 + seed) % 3 == 0 ? 1 : 0);
  return scene;
}

/// The same without them: their faces have no corners.
TestScene without_ghosts(const TestScene& scene) {
  TestScene rest = scene;
  rest.polygons.corners.clear();
  rest.polygons.first = {0};
  rest.polygons.is_ghost.clear();
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
    const auto corners = scene.polygons[f];
    if (scene.polygons.is_ghost[f] == 0)
      rest.polygons.corners.insert(rest.polygons.corners.end(), corners.begin(), corners.end());
    rest.polygons.first.push_back(static_cast<std::uint32_t>(rest.polygons.corners.size()));
  }
  return rest;
}

VisibleLines some(const VisibleLines& lines, bool of_ghosts) {
  VisibleLines some = lines;
  std::erase_if(some.lines, [&](const Line& l) { return l.is_ghost != of_ghosts; });
  return some;
}

struct Method {
  LineMethod method;
  When stages;
};
const Method methods[] = {{LineMethod::roberts, When::never},
                          {LineMethod::roberts, When::always},
                          {LineMethod::appel, When::never},
                          {LineMethod::appel, When::always}};

VisibleLines lines_by(const Method& m, const Mesh& mesh, const View& view) {
  LineOptions options = all_edges();
  options.method = m.method;
  SceneOptions of_scene;
  of_scene.stages.fill(m.stages);
  return visible_lines(SceneView(mesh, view, of_scene), options);
}

std::string text_of(const std::vector<Interval>& intervals) {
  std::string text;
  for (const Interval& i : intervals) text += i.from.get_str() + " to " + i.to.get_str() + "; ";
  return text;
}

/// What is visible and hidden of an edge if only faces that are no ghosts hide.
std::string by_oracle(const VisibleLinesOracle& oracle, const Mesh& mesh, const Edge& e) {
  const auto seen = oracle.visibility(oracle::Vec(mesh.points[e.a]), oracle::Vec(mesh.points[e.b]));
  return seen.is_seen ? "visible " + text_of(seen.visible) + "hidden " + text_of(seen.hidden) : "nothing";
}

std::string found(const Mesh& mesh, const View& view, const VisibleLines& lines, const Line& line) {
  if (line.intervals() == 0) return "nothing";
  const SupportingLine support = supporting_line_of(mesh, lines, line);
  std::vector<Interval> parts[2];
  for (std::uint32_t k = 0; k < line.intervals(); ++k) {
    const auto cuts = lines.cuts_of(line);
    parts[line.hidden(k) ? 1 : 0].push_back({oracle::exact(exact_parameter(mesh, view, support, cuts[k])),
                                             oracle::exact(exact_parameter(mesh, view, support, cuts[k + 1]))});
  }
  return "visible " + text_of(parts[0]) + "hidden " + text_of(parts[1]);
}

/// Whether the lines of the ghosts are those of all their edges, each in its class among the ghosts, hidden by the others.
void check_ghosts(const TestScene& scene, const Mesh& mesh, const VisibleLines& lines) {
  const Mesh solid = without_ghosts(scene).mesh();
  const VisibleLinesOracle oracle(solid, scene.view);
  const internal::ProjectedMesh among_ghosts(*mesh.ghosts, scene.view, Arithmetic::staged);
  const FaceLabels labels;
  const internal::EdgeMarkTable no_marks;
  const internal::EdgeClassifier classify(among_ghosts, labels, no_marks, all_edges());
  Predicates exact = among_ghosts.predicates();
  std::size_t expected = 0;
  std::map<std::uint32_t, const Line*> of_edge;
  for (const Line& line : lines.lines) CHECK(of_edge.emplace(line.edge.value, &line).second);
  for (std::size_t k = 0; k < mesh.ghosts->edges.size(); ++k) {
    const auto edge_class = classify(exact, EdgeId(k)).seen;
    if (!edge_class) continue;
    ++expected;
    const Edge& e = mesh.ghosts->edges[EdgeId(k)];
    const auto at = of_edge.find(mesh.find_edge(e.a, e.b).value);
    REQUIRE(at != of_edge.end());
    CHECK(at->second->edge_class == *edge_class);
    CHECK(found(mesh, scene.view, lines, *at->second) == by_oracle(oracle, mesh, e));
    for (const FaceId f : faces_at(mesh, lines, *at->second)) CHECK(scene.polygons.is_ghost[f.value] == 1);
  }
  CHECK(lines.lines.size() == expected);
}

TEST_CASE("ghosts hide nothing of anything, and are hidden by all others", "[lines][ghosts][O4][O5][O6]") {
  for (const scenes::Family& family : scenes::families()) {
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const TestScene scene = with_ghosts(family.make(seed), seed);
      const TestScene rest = without_ghosts(scene);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      const Mesh mesh = scene.mesh(), solid = rest.mesh();
      if (mesh.ghosts == nullptr) continue;
      const auto expected = oracle::seen_by_oracle(SceneView(solid, rest.view), all_edges());
      for (const Method& m : methods) {
        const VisibleLines lines = lines_by(m, mesh, scene.view);
        INFO((m.method == LineMethod::appel ? "appel" : "roberts") << (m.stages == When::always ? ", stages" : ""));
        std::string differences;
        for (const auto& d : oracle::differences(expected, oracle::seen_edges(mesh, scene.view, some(lines, false))))
          differences += d + "\n";
        CHECK(differences == "");
        check_ghosts(scene, mesh, some(lines, true));
      }
    }
  }
}

/// Text of all that polygons say, so that a difference shows where it is.
std::string text_of(const std::vector<PlacedPolygon>& polygons) {
  std::string text;
  for (const PlacedPolygon& p : polygons) {
    text += "face " + std::to_string(p.face.value) + ":";
    for (const auto& ring : p.rings)
      for (const PlacedPoint& c : ring)
        text += " " + std::to_string(c.space.x) + "," + std::to_string(c.space.y) + "," + std::to_string(c.space.z);
    text += "\n";
  }
  return text;
}

TEST_CASE("fragments, orders and the nearest faces are those of the scene without its ghosts", "[lines][ghosts][O4]") {
  for (const std::string name : {"triangles", "polygons", "boxes", "edge_on"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const TestScene scene = with_ghosts(scenes::family(name).make(seed), seed);
      const TestScene rest = without_ghosts(scene);
      INFO(name << " " << seed);
      const Mesh mesh = scene.mesh(), solid = rest.mesh();
      const SceneView seen(mesh, scene.view), expected(solid, rest.view);
      CHECK(text_of(polygons(seen, visible_fragments(seen))) == text_of(polygons(expected, visible_fragments(expected))));
      CHECK(text_of(polygons(seen, depth_sort(seen).order)) == text_of(polygons(expected, depth_sort(expected).order)));
      CHECK(text_of(polygons(seen, BspTree(mesh).order(seen))) == text_of(polygons(expected, BspTree(solid).order(expected))));
      const SampleGrid samples = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 24, 24);
      CHECK(cast(seen, samples).triangles.pixels == cast(expected, samples).triangles.pixels);
    }
  }
}

/// A box whose lid, the face at z = 1, is a ghost, and a wire inside of it.
TestScene box_with_ghost_lid() {
  TestScene scene;
  scene.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},        {0, 0, 1},
                  {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
  for (const std::vector<std::uint32_t>& face : std::vector<std::vector<std::uint32_t>>{
           {0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}})
    scene.add_face(face);
  scene.polygons.segments = {{8, 9}};
  scene.polygons.is_ghost = {0, 0, 0, 0, 0, 1};
  scene.view = scenes::from_direction({0, 0, 1});
  return scene;
}

TEST_CASE("a ghost closes no body: through it one sees what is inside", "[lines][ghosts][O4]") {
  const TestScene scene = box_with_ghost_lid();
  const Mesh mesh = scene.mesh();
  for (const Method& m : methods) {
    const VisibleLines lines = lines_by(m, mesh, scene.view);
    CHECK(lines.plan.method != "none");
    std::set<std::string> visible;
    for (const Line& line : lines.lines)
      if (line.intervals() == 1 && !line.starts_hidden)
        visible.insert((line.is_ghost ? "ghost " : "") + std::to_string(mesh.edges[line.edge].a.value) + "-" +
                       std::to_string(mesh.edges[line.edge].b.value));
    // The wire, the bottom's sides (which lie behind walls that are seen edge-on) not, the rim for the walls and for the lid.
    CHECK(visible ==
          std::set<std::string>{"8-9", "4-5", "5-6", "6-7", "4-7", "ghost 4-5", "ghost 5-6", "ghost 6-7", "ghost 4-7"});
  }
}

TEST_CASE("an edge of a face and of a ghost is a line of each", "[lines][ghosts][O5]") {
  const TestScene scene = box_with_ghost_lid();
  const Mesh mesh = scene.mesh();
  const VisibleLines lines = visible_lines(mesh, scene.view, all_edges());
  std::size_t of_ghost = 0;
  for (const Line& line : lines.lines) {
    if (!line.is_ghost) continue;
    ++of_ghost;
    CHECK(line.edge_class == EdgeClass::boundary);  // among the ghosts there is but the lid
    CHECK(faces_at(mesh, lines, line) == std::vector<FaceId>{FaceId(5)});
  }
  CHECK(of_ghost == 4);
}

}  // namespace
}  // namespace hsr
