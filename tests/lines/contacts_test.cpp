#include <catch2/catch.hpp>

#include "tests/lines/checked_lines.h"

// Faces that pierce each other, and edges that lie in faces which are not theirs. The oracle checks every scene; the texts say
// what a reader can work out by hand.

namespace hsr {
namespace {

using scenes::TestScene;

struct Seen {
  CheckedLines lines;
  explicit Seen(const TestScene& scene) : lines(scene) { CHECK(lines.differences() == ""); }

  /// The parts of an edge, one after the other.
  std::string edge(std::uint32_t a, std::uint32_t b) const {
    std::string text;
    for (const oracle::SeenEdge& e : lines.edges())
      if (e.a == VertexId(a) && e.b == VertexId(b))
        text += (text.empty() ? "" : "; ") + (oracle::to_text(e.edge_class) + (": " + oracle::intervals_text(e)));
    return text;
  }
  std::vector<std::string> intersections() const {
    std::vector<std::string> all;
    for (const oracle::SeenEdge& e : lines.edges())
      if (!e.a.is_valid()) all.push_back(oracle::to_text(e));
    return all;
  }
};

using Texts = std::vector<std::string>;

// A wall in the plane y = 0 from x = 0 to 4 and z = 0 to 3, in one piece.
TestScene wall(const View& view) {
  TestScene scene;
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}};
  scene.add_face({0, 1, 2, 3});
  scene.view = view;
  return scene;
}

void add_square(TestScene& scene, std::initializer_list<Point3> corners) {
  std::vector<std::uint32_t> face;
  for (const Point3& p : corners) {
    face.push_back(static_cast<std::uint32_t>(scene.points.size()));
    scene.points.push_back(p);
  }
  scene.add_face(face);
}

TEST_CASE("a partition that touches a facade from behind is not drawn on it", "[lines][contacts][C1][C3][C9]") {
  for (const View& view : {scenes::from_direction({0, -1, 0}), scenes::from_direction({1, -3, 1}),
                           scenes::from_eye({2, -5, 1}, {2, 0, 1}), scenes::from_eye({5, -5, 2}, {2, 0, 1})}) {
    TestScene scene = wall(view);
    add_square(scene, {{2, 0, 0}, {2, 4, 0}, {2, 4, 3}, {2, 0, 3}});
    CHECK(Seen(scene).edge(4, 7) == "smooth: 0 visible 1; sharp: 0 hidden 1");
  }
  TestScene behind = wall(scenes::from_direction({1, 3, 1}));
  add_square(behind, {{2, 0, 0}, {2, 4, 0}, {2, 4, 3}, {2, 0, 3}});
  CHECK(Seen(behind).edge(4, 7) == "sharp: 0 visible 1");  // there it divides the facade
}

TEST_CASE("a partition higher than its facade is drawn above it", "[lines][contacts][C3][C11]") {
  TestScene scene = wall(scenes::from_direction({1, -3, 1}));
  add_square(scene, {{2, 0, 0}, {2, 4, 0}, {2, 4, 6}, {2, 0, 6}});
  CHECK(Seen(scene).edge(4, 7) == "smooth: 0 visible 1/2; boundary: 1/2 visible 1; sharp: 0 hidden 1/2");
}

TEST_CASE("a floor through the line that divides a wall crosses it there", "[lines][contacts][C6][C10][C11]") {
  TestScene scene;
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 2}, {0, 0, 2}, {4, 0, 4}, {0, 0, 4}};
  scene.add_face({0, 1, 2, 3});
  scene.add_face({3, 2, 4, 5});
  add_square(scene, {{1, -2, 2}, {3, -2, 2}, {3, 2, 2}, {1, 2, 2}});
  scene.view = scenes::from_direction({1, -3, 1});
  const Seen above(scene);
  CHECK(above.edge(2, 3) == "smooth: 0 visible 1/4; intersection: 1/4 visible 3/4; smooth: 3/4 visible 1");
  CHECK(above.intersections().empty());  // it has an edge
  scene.view = scenes::from_direction({0, -1, 0});
  // The floor is seen edge-on, toward the eye and away from it.
  CHECK(Seen(scene).edge(2, 3) == "smooth: 0 visible 1/4; intersection: 1/4 hidden 3/4; smooth: 3/4 visible 1");
}

TEST_CASE("the ridge of a roof that touches a ceiling does not cross it", "[lines][contacts][C8]") {
  TestScene scene;
  scene.points = {{1, 0, -1}, {3, 0, -1}, {3, 1, 0}, {1, 1, 0}, {3, 2, -1}, {1, 2, -1}};
  scene.add_face({0, 1, 2, 3});
  scene.add_face({3, 2, 4, 5});
  add_square(scene, {{0, -1, 0}, {4, -1, 0}, {4, 3, 0}, {0, 3, 0}});
  scene.view = scenes::from_direction({0, -1, -3});  // from below
  CHECK(Seen(scene).edge(2, 3) == "sharp: 0 visible 1");
  scene.view = scenes::from_direction({0, -1, 3});
  CHECK(Seen(scene).edge(2, 3) == "smooth: 0 visible 1; sharp: 0 hidden 1");  // the ceiling is nearest on both sides
}

TEST_CASE("squares that pierce each other share a line", "[lines][contacts][I1][I5]") {
  TestScene scene;
  add_square(scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  add_square(scene, {{0, -1, -2}, {0, 1, -2}, {0, 1, 2}, {0, -1, 2}});
  scene.view = scenes::from_direction({1, 0, 1});
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 2 0,-1,0 to 0,1,0 intersection: 0 visible 1"});
  scene.view = scenes::from_eye({6, -6, 1}, {0, 0, 0});
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 2 0,-1,0 to 0,1,0 intersection: 0 visible 1"});
  scene.view = scenes::from_direction({0, 0, 1});  // the second is edge-on, and hides it
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 2 0,-1,0 to 0,1,0 intersection: 0 hidden 1"});
  scene.view = scenes::from_direction({0, 1, 0});  // both are: it is a point
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 2 0,-1,0 to 0,1,0 intersection: nothing"});
  scene.view = scenes::from_eye({0.5, -3, 1}, {0.5, 4, 1}, 3.5 / 7);  // the near plane: y = 0.5
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 2 0,1/2,0 to 0,1,0 intersection: 0 visible 1"});
}

TEST_CASE("a third face hides a part of where two pierce each other", "[lines][contacts][I1]") {
  TestScene scene;
  add_square(scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  add_square(scene, {{-1, -1, -1}, {-1, 1, -1}, {1, 1, 1}, {1, -1, 1}});
  add_square(scene, {{-1, -0.5, 5}, {1, -0.5, 5}, {1, 0.25, 5}, {-1, 0.25, 5}});
  scene.view = scenes::from_direction({0, 0, 1});
  CHECK(Seen(scene).intersections() ==
        Texts{"triangles 0 x 2 0,-1,0 to 0,1,0 intersection: 0 visible 1/4 hidden 5/8 visible 1"});
}

TEST_CASE("where faces of several triangles pierce each other there is one line", "[lines][contacts][I3]") {
  TestScene scene;
  // A U, its arms to the right; the second square stands across both arms, the third along the diagonals of its own.
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}};
  scene.add_face({0, 1, 2, 3, 4, 5, 6, 7});
  add_square(scene, {{2, -1, -1}, {2, 5, -1}, {2, 5, 1}, {2, -1, 1}});
  scene.view = scenes::from_direction({1, 0, 1});
  CHECK(Seen(scene).intersections() == Texts{"triangles 0 x 6 2,0,0 to 2,1,0 intersection: 0 visible 1",
                                             "triangles 0 x 6 2,3,0 to 2,4,0 intersection: 0 visible 1"});
  TestScene diagonal;
  add_square(diagonal, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  add_square(diagonal, {{-1, -1, -1}, {5, 5, -1}, {5, 5, 1}, {-1, -1, 1}});
  diagonal.view = scenes::from_direction({1, -2, 3});
  CHECK(Seen(diagonal).intersections() == Texts{"triangles 0 x 2 0,0,0 to 4,4,0 intersection: 0 visible 1"});
}

TEST_CASE("what touches a wall pierces nothing", "[lines][contacts][I2]") {
  TestScene scene = wall(scenes::from_direction({1, -3, 1}));
  add_square(scene, {{1, 0, 1}, {1, -2, 1}, {2, -2, 2}});                     // a corner in the wall
  add_square(scene, {{3, 0, 1}, {3, -1, 1}, {3, -1, 2}, {3, 0, 2}});          // an edge in it
  add_square(scene, {{0.5, 0, 0.5}, {1.5, 0, 0.5}, {1.5, 0, 1.5}});           // all of it
  add_square(scene, {{4, -1, 0.5}, {4, 1, 0.5}, {4, 1, 2.5}, {4, -1, 2.5}});  // through its edge: it lies along a side
  CHECK(Seen(scene).intersections().empty());
}

TEST_CASE("a wire in a face, or where faces pierce each other, stays a wire", "[lines][contacts][C16]") {
  TestScene scene = wall(scenes::from_direction({1, -3, 1}));
  add_square(scene, {{1, -1, 1}, {3, -1, 1}, {3, 1, 1}, {1, 1, 1}});
  const auto first = static_cast<std::uint32_t>(scene.points.size());
  for (const Point3& p : {Point3{1, 0, 1}, {3, 0, 1}, {1, 0, 2}, {2, 0, 2.5}}) scene.points.push_back(p);
  scene.polygons.segments = {{first, first + 1}, {first + 2, first + 3}};
  const Seen seen(scene);
  CHECK(seen.edge(first, first + 1) == "wire: 0 visible 1");
  CHECK(seen.edge(first + 2, first + 3) == "wire: 0 visible 1");
  CHECK(seen.intersections() == Texts{"triangles 0 x 2 1,0,1 to 3,0,1 intersection: 0 visible 1"});
}

}  // namespace
}  // namespace hsr
