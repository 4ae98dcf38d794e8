#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "geometry/error.h"
#include "tests/lines/checked_lines.h"
#include "tests/lines/labelled_scene.h"
#include "tests/oracle/exact_vector.h"
#include "tests/scenes/random_scenes.h"

// Surfaces of which faces are parts, and marks of edges: they stand above the crease (C23 to C25).

namespace hsr {
namespace {

using scenes::TestScene;

/// Two faces that meet in the edge from 0 to 1, seen from above; the second rises from it.
TestScene folded(double rise) {
  TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  scene.points = {{0, 0, 0}, {0, 4, 0}, {3, 2, 0}, {-3, 2, rise}};
  scene.add_face({0, 1, 2});
  scene.add_face({0, 1, 3});
  return scene;
}

/// "sharp", or "absent".
std::string class_of(const TestScene& scene, const FaceLabels& labels, std::uint32_t a = 0, std::uint32_t b = 1) {
  const Mesh mesh = scene.mesh();
  const SceneView view(Scene::of(mesh, labels), scene.view);
  const VisibleLines lines = visible_lines(view, all_edges());
  CHECK(oracle::compare_with_oracle(view, lines, all_edges()) == std::vector<std::string>{});
  std::string found = "absent";
  for (const Line& line : lines.lines)
    if (!line.is_intersection() && mesh.edges[line.edge].a == VertexId(a) && mesh.edges[line.edge].b == VertexId(b))
      found = oracle::to_text(line.edge_class);
  return found;
}

FaceLabels marked(EdgeMark mark, std::uint32_t a = 0, std::uint32_t b = 1) {
  FaceLabels labels;
  labels.marks = {{{a, b}, mark}};
  return labels;
}

TEST_CASE("within one surface there is no edge but an outline, whatever the crease", "[lines][marks][C23]") {
  FaceLabels one, two, unknown;
  one.surface = {7, 7};
  two.surface = {7, 8};
  unknown.surface = {FaceLabels::none, FaceLabels::none};
  const double steep = 9;
  CHECK(class_of(folded(steep), {}) == "sharp");
  CHECK(class_of(folded(steep), one) == "absent");
  CHECK(class_of(folded(steep), two) == "sharp");
  CHECK(class_of(folded(steep), unknown) == "sharp");
  CHECK(class_of(folded(0), one) == "absent");
  CHECK(class_of(folded(0), two) == "smooth");
  TestScene from_the_side = folded(steep);
  from_the_side.view = scenes::from_direction({-3, 0, 1.5});
  CHECK(class_of(from_the_side, one) == "outline");
}

TEST_CASE("a mark stands above the crease", "[lines][marks][C24]") {
  for (const double rise : {0.0, 0.125, 9.0}) {
    INFO(rise);
    CHECK(class_of(folded(rise), marked(EdgeMark::inner)) == "absent");
    CHECK(class_of(folded(rise), marked(EdgeMark::smooth)) == "smooth");
    CHECK(class_of(folded(rise), marked(EdgeMark::sharp)) == "sharp");
    CHECK(class_of(folded(rise), marked(EdgeMark::sharp, 1, 0)) == "sharp");
    CHECK(class_of(folded(rise), marked(EdgeMark::sharp, 0, 2)) == class_of(folded(rise), {}));
  }
  FaceLabels labels = marked(EdgeMark::smooth);
  labels.material = {0, 1};
  CHECK(class_of(folded(9), labels) == "material");
  labels = marked(EdgeMark::inner);
  labels.material = {0, 1};
  CHECK(class_of(folded(9), labels) == "absent");
}

TEST_CASE("a mark stands above the surface, and of several marks the strongest counts", "[lines][marks][C24]") {
  FaceLabels labels = marked(EdgeMark::sharp);
  labels.surface = {0, 0};
  CHECK(class_of(folded(0.125), labels) == "sharp");
  labels.marks = {{{0, 1}, EdgeMark::inner}, {{1, 0}, EdgeMark::sharp}, {{0, 1}, EdgeMark::smooth}};
  CHECK(class_of(folded(0.125), labels) == "sharp");
  labels.marks = {{{0, 1}, EdgeMark::inner}, {{1, 0}, EdgeMark::smooth}};
  CHECK(class_of(folded(9), labels) == "smooth");
}

TEST_CASE("what is an outline, a boundary or the foot of a wall stays that", "[lines][marks][C24]") {
  TestScene one_side = folded(9);
  one_side.view = scenes::from_direction({-3, 0, 1.5});
  TestScene alone = folded(9);
  alone.polygons = {};
  alone.add_face({0, 1, 2});
  TestScene with_wall = folded(0);
  with_wall.points.push_back({0, 2, 5});
  with_wall.add_face({0, 1, 4});
  for (const EdgeMark mark : {EdgeMark::inner, EdgeMark::smooth}) {
    CHECK(class_of(one_side, marked(mark)) == "outline");
    CHECK(class_of(alone, marked(mark)) == "boundary");
    CHECK(class_of(with_wall, marked(mark)) == "sharp");
  }
}

TEST_CASE("a mark counts along every part of its segment, between faces of its object", "[lines][marks][C25]") {
  // The face on the left has an edge of its own that is half as long.
  TestScene scene = folded(9);
  scene.points.push_back({0, 2, 0});
  scene.polygons = {};
  scene.add_face({0, 1, 2});
  scene.add_face({0, 4, 3});
  CHECK(class_of(scene, {}, 0, 4) == "sharp");
  CHECK(class_of(scene, marked(EdgeMark::inner, 0, 1), 0, 4) == "absent");
  CHECK(class_of(scene, marked(EdgeMark::smooth, 0, 4), 0, 4) == "smooth");

  // Two rounded plates on one another: their smooth edges coincide, and the groove between them is an edge all the same.
  TestScene plates;
  plates.view = scenes::from_direction({1, 0, 0});
  plates.points = {{0, 0, 0}, {0, 4, 0}, {-3, 2, 0}, {1, 2, 2}, {1, 2, -2}};
  plates.add_face({0, 1, 2});
  plates.add_face({0, 1, 3});
  plates.add_face({0, 1, 2});
  plates.add_face({0, 1, 4});
  FaceLabels labels;
  labels.object = {0, 0, 1, 1};
  labels.marks = {{{0, 1}, EdgeMark::smooth, 0}, {{0, 1}, EdgeMark::smooth, 1}};
  CHECK(class_of(plates, labels) == "sharp");
  labels.object = {0, 0, 0, 0};
  CHECK(class_of(plates, labels) == "smooth");
}

TEST_CASE("a mark of a point that is not there is refused", "[lines][marks][C24]") {
  CHECK_THROWS_WITH(Scene(folded(1).mesh(), marked(EdgeMark::sharp, 0, 9)),
                    "mark 0: found point 9, expected one of the 4 of the model");
  CHECK(class_of(folded(9), marked(EdgeMark::inner, 2, 3)) == "sharp");
}

TEST_CASE("faces of one shape that pierce each other draw no line", "[lines][marks][I6]") {
  TestScene scene;
  scene.view = scenes::from_direction({0, 0.125, 1});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  scene.add_face(std::vector<Point3>{{1, 1, -1}, {3, 1, -1}, {3, 3, 1}, {1, 3, 1}});
  const Mesh mesh = scene.mesh();
  const auto intersections = [&](const FaceLabels& labels, bool diagonals) {
    LineOptions options = all_edges();
    options.diagonals = diagonals;
    std::size_t count = 0;
    const VisibleLines lines = visible_lines(SceneView(Scene::of(mesh, labels), scene.view), options);
    for (const Line& line : lines.lines) count += line.edge_class == EdgeClass::intersection ? 1 : 0;
    return count;
  };
  FaceLabels one, two, unknown;
  one.shape = {5, 5};
  two.shape = {5, 6};
  unknown.shape = {FaceLabels::none, FaceLabels::none};
  CHECK(intersections({}, false) == 1);
  CHECK(intersections(one, false) == 0);
  CHECK(intersections(one, true) == 1);
  CHECK(intersections(two, false) == 1);
  CHECK(intersections(unknown, false) == 1);
}

/// Labels and marks of every kind, by chance.
FaceLabels chance(const Mesh& mesh, std::uint64_t seed) {
  std::uint64_t state = seed * 0x9e3779b97f4a7c15U + 1;
  const auto next = [&](std::uint32_t below) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<std::uint32_t>((state >> 33) % below);
  };
  FaceLabels labels;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    labels.object.push_back(next(2));
    labels.material.push_back(next(5) == 0 ? 1 : 0);
    labels.surface.push_back(next(4) == 0 ? FaceLabels::none : next(3));
    labels.shape.push_back(next(4) == 0 ? FaceLabels::none : next(3));
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (std::uint32_t object = 0; object < 2; ++object)
      if (next(3) == 0)
        labels.marks.push_back(
            {{mesh.edges[EdgeId(e)].b.value, mesh.edges[EdgeId(e)].a.value}, static_cast<EdgeMark>(next(3)), object});
  return labels;
}

std::string wrong_with_marks(const TestScene& scene, std::uint64_t seed) {
  const Mesh mesh = scene.mesh();
  const Scene labelled = Scene::of(mesh, chance(mesh, seed));
  std::string wrong;
  for (const LineMethod method : {LineMethod::roberts, LineMethod::appel}) {
    LineOptions options = all_edges();
    options.method = method;
    const SceneView view(labelled, scene.view);
    for (const std::string& difference : oracle::compare_with_oracle(view, visible_lines(view, options), options))
      wrong += difference + "\n";
  }
  return wrong;
}

TEST_CASE("both methods agree with the oracle on scenes with surfaces and marks", "[lines][marks][oracle][C23][C24][C25]") {
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const TestScene scene = family.make(seed);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      REQUIRE(wrong_with_marks(scene, seed) == "");
    }
}

/// The scene with surfaces by chance, and a mark on some sides of faces.
Labelled with_marks(const TestScene& scene, std::uint64_t seed) {
  Labelled x{scene, {}};
  x.labels = chance(scene.mesh(), seed);
  return x;
}

/// The marks of `x` on the sides that faces of `y`, cut otherwise, have: on each that lies on a marked edge of x.
std::vector<MarkedEdge> marks_on(const Labelled& x, const Labelled& y) {
  using oracle::Vec;
  const Mesh mesh = y.scene.mesh();
  std::vector<MarkedEdge> marks;
  for (const MarkedEdge& m : x.labels.marks) {
    const Vec a(x.scene.points[m.points[0]]), along = Vec(x.scene.points[m.points[1]]) - a;
    const auto is_on = [&](VertexId v) {
      const Vec p = Vec(mesh.points[v]) - a;
      return is_zero(cross(p, along)) && sgn(dot(p, along)) >= 0 && dot(p, along) <= dot(along, along);
    };
    for (std::size_t e = 0; e < mesh.edges.size(); ++e)
      if (const Edge& edge = mesh.edges[EdgeId(e)]; is_on(edge.a) && is_on(edge.b))
        marks.push_back({{edge.a.value, edge.b.value}, m.mark, m.object});
  }
  return marks;
}

TEST_CASE("how faces are cut changes no ink of surfaces and marks", "[lines][marks][metamorphic][C23][C25]") {
  const std::pair<const char*, Recut> ways[] = {
      {"sides cut in three", with_cut_sides}, {"in halves", in_halves}, {"turned over", turned_over}};
  int inked = 0;
  for (const char* name : {"polygons", "boxes", "edge_on"})
    for (std::uint64_t seed = 730'000; seed < 730'012; ++seed) {
      const Labelled x = with_marks(scenes::family(name).make(seed), seed);
      const std::string ink = x.ink();
      inked += ink.empty() ? 0 : 1;
      for (const auto& [way, cut] : ways) {
        Labelled y = recut(x, cut);
        y.labels.marks = marks_on(x, y);
        INFO(name << " " << seed << ", " << way << "\n" << scenes::to_text(x.scene));
        CHECK(difference(ink, y.ink()) == "");
      }
    }
  CHECK(inked > 30);
}

}  // namespace
}  // namespace hsr
