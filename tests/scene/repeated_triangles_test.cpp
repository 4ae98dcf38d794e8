#include "hsr/scene/repeated_triangles.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "hsr/scene/intersections.h"
#include "hsr/scene/scene.h"
#include "hsr/scene/view_parts.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// The faces of a scene, all of them `copies` times, one round after the other.
scenes::TestScene copied(const scenes::TestScene& scene, int copies) {
  scenes::TestScene all;
  all.view = scene.view;
  for (int k = 0; k < copies; ++k)
    for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
      std::vector<Point3> corners;
      for (const std::uint32_t c : scene.polygons[f]) corners.push_back(scene.points[c]);
      all.add_face(corners);
    }
  return all;
}

Intersections found_in(const Mesh& mesh, const View& view) {
  const SceneView scene(mesh, view);
  return find_intersections(scene.parts().projected(), scene.parts().occluders(Excluded::none));
}

TEST_CASE("a triangle is the first with its corners and edges, whichever way round it is stored", "[scene][repeated]") {
  scenes::TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  const Point3 a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0};
  scene.add_face({a, b, c, d});
  scene.add_face({c, b, a, d});
  scene.add_face({b, a, c});  // half of them: its third side is an edge
  scene.add_face({c, a, b});
  const Mesh mesh = scene.mesh();
  REQUIRE(mesh.triangles.size() == 6);
  const RepeatedTriangles repeated(mesh);
  for (const std::uint32_t t : {0U, 1U, 4U}) CHECK(repeated.first(TriangleId(t)) == TriangleId(t));
  CHECK(std::set{repeated.first(TriangleId(2)), repeated.first(TriangleId(3))} == std::set{TriangleId(0), TriangleId(1)});
  CHECK(repeated.first(TriangleId(5)) == TriangleId(4));
}

TEST_CASE("none is repeated where every edge has two triangles that differ", "[scene][repeated]") {
  scenes::TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  const Point3 a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0}, d{0, 0, 2};
  for (const auto& face : {std::array{a, c, b}, std::array{a, b, d}, std::array{b, c, d}, std::array{c, a, d}})
    scene.add_face({face[0], face[1], face[2]});
  CHECK(RepeatedTriangles(scene.mesh()).empty());
}

TEST_CASE("faces that are stored three times meet as often as each with each, and touch what one touches",
          "[scene][repeated]") {
  std::size_t meeting = 0, touching = 0;
  for (const char* family : {"triangles", "polygons", "boxes", "stacks"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      CAPTURE(family, seed);
      const scenes::TestScene scene = scenes::family(family).make(seed);
      const Mesh once = copied(scene, 1).mesh(), thrice = copied(scene, 3).mesh();
      const auto n = static_cast<std::uint32_t>(once.triangles.size());
      REQUIRE(thrice.triangles.size() == 3 * n);
      const Intersections one = found_in(once, scene.view), three = found_in(thrice, scene.view);
      std::multiset<std::array<std::uint32_t, 2>> expected, found;
      for (const TriangleIntersection& x : one.segments)
        for (int k = 0; k < 9; ++k) expected.insert({x.s.value, x.t.value});
      for (const TriangleIntersection& x : three.segments) {
        const std::uint32_t s = x.s.value % n, t = x.t.value % n;
        found.insert({std::min(s, t), std::max(s, t)});
      }
      CHECK(found == expected);
      REQUIRE(three.has_contact.size() == one.has_contact.size());
      for (std::size_t e = 0; e < one.has_contact.size(); ++e) {
        if (one.has_contact[e] != 0) CHECK(three.has_contact[e] != 0);
        touching += one.has_contact[e];
      }
      meeting += one.segments.size();
    }
  CHECK(meeting > 50);
  CHECK(touching > 50);
}

}  // namespace
}  // namespace hsr
