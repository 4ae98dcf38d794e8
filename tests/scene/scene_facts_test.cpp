#include "hsr/scene/scene_facts.h"

#include <catch2/catch.hpp>
#include <vector>

using namespace hsr;
using namespace hsr::internal;

namespace {

Polygons polygons(const std::vector<std::vector<std::uint32_t>>& faces) {
  Polygons p;
  for (const auto& face : faces) {
    p.corners.insert(p.corners.end(), face.begin(), face.end());
    p.first.push_back(static_cast<std::uint32_t>(p.corners.size()));
  }
  return p;
}

SceneFacts facts(const std::vector<Point3>& points, const Polygons& p) { return scene_facts(make_mesh(points, p), p); }

const std::vector<Point3> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::vector<std::uint32_t>> cube_faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

}  // namespace

TEST_CASE("A cube is closed, manifold, oriented, one piece", "[scene_facts]") {
  const SceneFacts f = facts(cube, polygons(cube_faces));
  CHECK(f.points == 8);
  CHECK(f.used_points == 8);
  CHECK(f.quadrangular == 6);
  CHECK(f.triangles == 12);
  CHECK(f.used_as == std::array<std::size_t, face_use_count>{6, 0, 0, 0});
  CHECK(f.regular_edges == 12);
  CHECK(f.coplanar_edges == 0);
  CHECK(f.axis_parallel_faces == 6);
  CHECK(f.components == 1);
  CHECK(f.is_closed());
  CHECK(f.is_manifold());
  CHECK(f.is_consistently_oriented());
  CHECK(f.lowest == Point3{0, 0, 0});
  CHECK(f.highest == Point3{1, 1, 1});
  CHECK(f.coordinates.bits() == 1);
}

TEST_CASE("An open, a flipped, a doubled and a split face are each counted", "[scene_facts]") {
  auto faces = cube_faces;
  faces.pop_back();
  SceneFacts f = facts(cube, polygons(faces));
  CHECK(f.boundary_edges == 4);
  CHECK_FALSE(f.is_closed());

  faces = cube_faces;
  std::swap(faces[1][1], faces[1][3]);
  f = facts(cube, polygons(faces));
  CHECK(f.is_closed());
  CHECK(f.flipped_edges == 4);

  faces = cube_faces;
  faces.push_back({1, 2, 3, 0});
  faces.push_back({0, 3, 2, 1});
  f = facts(cube, polygons(faces));
  CHECK(f.duplicate_faces == 2);
  CHECK(f.non_manifold_edges == 4);
  CHECK(f.is_closed());  // four at each

  faces = cube_faces;
  faces[0] = {3, 2, 1};
  faces.push_back({1, 0, 3});
  f = facts(cube, polygons(faces));
  CHECK(f.triangular == 2);
  CHECK(f.regular_edges == 13);
  CHECK(f.coplanar_edges == 1);
}

TEST_CASE("Two cubes that share a corner are one component with a pinched vertex", "[scene_facts]") {
  std::vector<Point3> points = cube;
  auto faces = cube_faces;
  for (const Point3& p : cube) points.push_back({p.x + 1, p.y + 1, p.z + 1});
  for (const auto& face : cube_faces) {
    faces.push_back(face);
    for (std::uint32_t& corner : faces.back()) corner += 8;
  }
  const SceneFacts f = facts(points, polygons(faces));
  CHECK(f.points == 16);
  CHECK(f.distinct_points == 15);
  CHECK(f.components == 1);
  CHECK(f.pinched_vertices == 1);
  CHECK(f.non_manifold_edges == 0);
  CHECK_FALSE(f.is_manifold());
  CHECK(f.is_closed());
}

TEST_CASE("A diagonal of a bent face along an edge of other faces is not counted there", "[scene_facts]") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0, 0, 5}, {0, 0, 9}};
  Polygons p = polygons({{0, 1, 2, 3}, {0, 2, 4}});
  p.segments = {{0, 5}, {1, 2}};
  const SceneFacts f = facts(points, p);
  CHECK(f.used_as == std::array<std::size_t, face_use_count>{1, 1, 0, 0});
  CHECK(f.boundary_edges == 7);
  CHECK(f.non_manifold_edges == 0);
  CHECK(f.wires == 2);
  CHECK(f.used_points == 6);
}

TEST_CASE("An empty scene has no facts", "[scene_facts]") {
  const SceneFacts f = facts({}, {});
  CHECK(f.components == 0);
  CHECK_FALSE(f.is_closed());
  CHECK(f.coordinates.is_zero());
}
