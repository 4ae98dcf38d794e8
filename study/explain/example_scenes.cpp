#include "study/explain/example_scenes.h"

#include <array>
#include <initializer_list>
#include <span>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

using Ring = std::vector<Point3>;

/// @param names of nothing: faces are lettered
ExplainedScene scene_of(const std::string& title, const std::vector<Ring>& faces, const View& view) {
  ExplainedScene scene;
  scene.title = title;
  scene.model.name = title;
  for (const Ring& face : faces) {
    for (const Point3& p : face) {
      scene.model.polygons.corners.push_back(static_cast<std::uint32_t>(scene.model.points.size()));
      scene.model.points.push_back(p);
    }
    scene.model.polygons.first.push_back(static_cast<std::uint32_t>(scene.model.polygons.corners.size()));
  }
  scene.mesh = make_mesh(scene.model.points, scene.model.polygons);
  scene.view = view;
  return scene;
}

View from_above() { return parallel_view({0, 0, 1}, {0, 1, 0}, {5, 5, 0}); }

/// A strip in the plane z = a + b x + c y.
Ring strip(double x0, double y0, double x1, double y1, double a, double b, double c) {
  const auto at = [&](double x, double y) { return Point3{x, y, a + b * x + c * y}; };
  return {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
}

/// Three strips, each over the next and the last over the first; two faces below them. Triangles, since of two of these that are apart in
/// depth the depths tell first.
ExplainedScene ring_scene() {
  return scene_of("three strips that overlap in a ring, over a triangle and a square, from above",
                  {strip(0, 1, 10, 3, 0, 0.5, 0),                 // low on the left, high on the right
                   {{7, 0, 0}, {9, 0, 0}, {6, 9, 9}, {4, 9, 9}},  // low below, high above
                   {{5.5, 9.5, 5}, {3.5, 9.5, 5}, {1, 0.5, 4}},   // between them on both sides
                   {{0.5, 4, -2}, {4.5, 4, -2}, {2.5, 9, -2}},
                   strip(5.5, 4.5, 9.5, 8.5, -1, 0, -0.1)},
                  from_above());
}

/// Two faces that pierce each other, over a floor.
ExplainedScene pierced_scene() {
  return scene_of("two sheets that pierce each other, over a floor, from above",
                  {strip(0, 0, 10, 10, 0, 0, 0), strip(1, 2, 9, 6, 1, 0.5, 0), strip(2, 4, 8, 9, 5, -0.5, 0)}, from_above());
}

/// A block with a gable roof, and a wall before it.
ExplainedScene house_scene() {
  const Point3 a{0, 0, 0}, b{4, 0, 0}, c{4, 3, 0}, d{0, 3, 0}, e{0, 0, 2}, f{4, 0, 2}, g{4, 3, 2}, h{0, 3, 2}, r{0, 1.5, 3.2},
      s{4, 1.5, 3.2};
  return scene_of("a house and a wall before it",
                  {{a, b, f, e},
                   {b, c, g, s, f},
                   {c, d, h, g},
                   {d, a, e, r, h},
                   {e, f, s, r},
                   {g, h, r, s},
                   {{1, -2, 0}, {5, -2, 0}, {5, -2, 1.25}, {1, -2, 1.25}}},
                  parallel_view({1, -2, 1}, {0, 0, 1}, {2, 1, 1}));
}

/// Triangles in front of one another and through one another, for pictures of samples.
ExplainedScene triangles_scene() {
  return scene_of("three triangles, one of which leans through another, from above",
                  {{{4.3, 0.2, 2}, {9.8, 0.6, 2}, {7.1, 6.2, 2}},
                   {{0.3, 0.5, 1}, {8.7, 1.5, 1}, {2.6, 8.7, 1}},
                   {{9.6, 3.2, 0}, {8.2, 9.4, 3}, {0.8, 4.6, 4}}},
                  from_above());
}

/// Two long faces and a short one whose middle lies between theirs.
ExplainedScene middle_scene() {
  return scene_of("a long ramp under a small plate, and a ring of three, from above",
                  {strip(0, 0.5, 10, 2.5, 0, 1, 0),
                   strip(1, 0.2, 3, 2.8, 4, 0, 0),
                   {{7.6, 3.2, 0}, {9.2, 3.2, 0}, {6.5, 9.5, 9}, {4.9, 9.5, 9}},
                   strip(0.5, 3.8, 9.5, 5.3, 0, 0.5, 0),
                   {{6, 9.8, 5}, {4.2, 9.8, 5}, {1.2, 3.3, 4}, {3, 3.3, 4}}},
                  from_above());
}

/// Upright walls on a floor, as plans show them: some stand across the planes of others.
ExplainedScene walls_scene() {
  const auto wall = [](double x0, double y0, double x1, double y1) {
    return Ring{{x0, y0, 0}, {x1, y1, 0}, {x1, y1, 2}, {x0, y0, 2}};
  };
  return scene_of("six walls",
                  {wall(0, 0, 6, 0), wall(6, 1, 6, 6), wall(1, 5, 4, 7), wall(2, 2, 4, 3), wall(3, 4, 8, 4), wall(0, 2, 1, 4)},
                  parallel_view({1, -2, 1.5}, {0, 0, 1}, {3, 3, 1}));
}

/// Plates of which an order exists: most tests decide about some two of them.
ExplainedScene plates_scene() {
  return scene_of("plates that lie in, lean on and stand over one another, from above",
                  {strip(0, 0.5, 5, 4.5, 0, 0, 0), strip(4, 1.5, 9.5, 6, 0, 0, 0), strip(0.5, 1, 4.5, 4, 3, -0.2, 0),
                   strip(3.5, 4, 6.5, 9, -1, -0.4, 0.4), strip(4, 3, 8.5, 5.5, 3, -0.2, 0.4)},
                  from_above());
}

/// So many sheets through one another that cutting them pair by pair would take long.
ExplainedScene star_scene() {
  std::vector<Ring> sheets;
  for (const auto& [x, y] : std::initializer_list<std::array<double, 2>>{
           {3, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 3}, {-1, 3}, {-2, 3}, {-3, 2}, {-3, 1}})
    sheets.push_back({{x, y, 0}, {-x, -y, 0}, {-x, -y, 3}, {x, y, 3}});
  return scene_of("ten sheets through one axis", sheets, parallel_view({1, -4, 2}, {0, 0, 1}, {0, 0, 1.5}));
}

/// A strip behind two triangles that overlap: few edges, for lines and fragments of one scene.
ExplainedScene strip_scene() {
  return scene_of(
      "a strip behind two triangles that overlap each other, from above",
      {strip(0, 3, 10, 6, 0, 0, 0), {{1.5, 1.5, 1}, {6.5, 1, 1}, {4, 8, 1}}, {{4.5, 1.8, 3}, {8.5, 2.2, 3}, {6.5, 7.5, 2}}},
      from_above());
}

/// Something for each culling: beside the picture, turned away, behind a plate, and small.
ExplainedScene yard_scene() {
  return scene_of("plates: some beside the picture, one behind another, one turned away, one small, from above",
                  {strip(1, 3, 6, 9, 6, 0, 0),
                   strip(2, 4, 5, 8, 1, 0, 0),
                   strip(0.5, 1, 3, 5, 2, 0, 0.2),
                   {{8, 8.5, 1}, {8.6, 8.5, 1}, {8.2, 9, 1}},
                   {{7, 5, 2}, {7.5, 7.5, 3}, {9.5, 7, 2}},
                   strip(-3, 4, -1.5, 6, 0, 0, 0),
                   strip(-1, 0.5, 0.6, 2.5, 0, 0.3, 0)},
                  from_above());
}

}  // namespace

ExplainedScene example_scene(const std::string& name) {
  if (name == "ring") return ring_scene();
  if (name == "pierced") return pierced_scene();
  if (name == "house") return house_scene();
  if (name == "triangles") return triangles_scene();
  if (name == "middle") return middle_scene();
  if (name == "walls") return walls_scene();
  if (name == "plates") return plates_scene();
  if (name == "star") return star_scene();
  if (name == "strip") return strip_scene();
  if (name == "yard") return yard_scene();
  throw InputError("explain: found no example \"" + name + "\"");
}

}  // namespace hsr::internal
