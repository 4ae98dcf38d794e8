#include "hsr/scene/float_triangle.h"

#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "geometry/mesh.h"
#include "tests/scenes/test_scene.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// Whether a side of t certainly crosses the inside of s.
bool pierces(const ProjectedMesh& projected, TriangleId t, TriangleId s, Predicates& exact) {
  const auto &c = projected.mesh().triangles[t], &d = projected.mesh().triangles[s];
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &p = projected.point(c[k]), &q = projected.point(c[(k + 1) % 3]);
    if (exact.side(projected.face_plane(s), p) * exact.side(projected.face_plane(s), q) != Sign::negative) continue;
    std::array<Sign, 3> turn;
    for (std::size_t m = 0; m < 3; ++m)
      turn[m] = exact.side(Plane::of_face(p, q, projected.point(d[m])), projected.point(d[(m + 1) % 3]));
    if (turn[0] != Sign::zero && turn[0] == turn[1] && turn[1] == turn[2]) return true;
  }
  return false;
}

/// Two triangles: apart by chance, with a common corner, with a common side, or one with a corner just off the other's plane.
std::vector<Point3> two_triangles(std::mt19937_64& random, int kind, double gap) {
  const auto unit = [&] { return static_cast<double>(random() % 2000003) / 1000001 - 1; };
  std::vector<Point3> p(6);
  for (Point3& q : p) q = {unit(), unit(), unit()};
  if (kind == 1) p[3 + random() % 3] = p[random() % 3];
  if (kind == 2) {
    p[3] = p[1];
    p[4] = p[0];
  }
  if (kind == 3) {
    const double a = (unit() + 1) / 2, b = (unit() + 1) / 2 * (1 - a);
    for (int k = 0; k < 3; ++k)
      (k == 0 ? p[3].x : k == 1 ? p[3].y : p[3].z) = p[0][k] + a * (p[1][k] - p[0][k]) + b * (p[2][k] - p[0][k]) + gap * unit();
  }
  return p;
}

}  // namespace

TEST_CASE("triangles that pierce each other are never told apart by floats", "[scene][float_triangle][property]") {
  std::mt19937_64 random(17);
  std::size_t apart = 0, piercing = 0, all = 0;
  for (const View& view :
       {scenes::from_direction({1, -2, 3}), scenes::from_direction({0, 0, 1}), scenes::from_eye({3, -4, 2}, {0, 0, 0})})
    for (int i = 0; i < 30000; ++i) {
      // Sizes and places that leave the floats few digits, and gaps at their last one and at that of doubles.
      const double size = i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p-8 : 0x1p-16, gap = i % 2 == 0 ? 0x1p-22 : 0x1p-50;
      std::vector<Point3> points = two_triangles(random, i % 4, gap);
      for (Point3& p : points) p = {0.7 + size * p.x, -0.4 + size * p.y, 0.2 + size * p.z};
      points.push_back({1, 1, 1});  // a third one, so that the others are small and off the middle
      points.push_back({-1, 0.5, -1});
      points.push_back({0.25, -1, 1});
      const Mesh mesh = make_mesh(points, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
      if (mesh.triangles.size() != 3) continue;
      const ProjectedMesh projected(mesh, view, Arithmetic::staged);
      const FloatTriangle s(projected, TriangleId(0), true), t(projected, TriangleId(1), true);
      Predicates exact = projected.predicates();
      const bool do_pierce =
          pierces(projected, TriangleId(0), TriangleId(1), exact) || pierces(projected, TriangleId(1), TriangleId(0), exact);
      const bool are_apart = TriangleSeparation(s).is_apart_from(t);
      CHECK_FALSE((do_pierce && are_apart));
      ++all;
      apart += are_apart ? 1U : 0U;
      piercing += do_pierce ? 1U : 0U;
    }
  CHECK(piercing > all / 20);
  CHECK(apart > all / 4);
}

TEST_CASE("neighbours on opposite sides of their common side or corner are told apart", "[scene][float_triangle]") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0.1}, {0.5, -1, 0.1}, {-1, -0.5, 0}, {-1, 0.5, 0}};
  const Mesh mesh = make_mesh(points, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}, {0, 5, 4}, {0, 1, 2}});
  const ProjectedMesh projected(mesh, scenes::from_direction({0, 0, 1}), Arithmetic::staged);
  const auto triangle = [&](std::size_t t, bool is_single) { return FloatTriangle(projected, TriangleId(t), is_single); };
  const FloatTriangle s = triangle(0, true), by_side = triangle(1, true), by_corner = triangle(2, true),
                      in_polygon = triangle(1, false);
  CHECK(TriangleSeparation(s).is_apart_from(by_side));
  CHECK(TriangleSeparation(s).is_apart_from(by_corner));
  CHECK_FALSE(TriangleSeparation(s).is_apart_from(in_polygon));
  CHECK_FALSE(TriangleSeparation(s).is_apart_from(triangle(3, true)));
}
