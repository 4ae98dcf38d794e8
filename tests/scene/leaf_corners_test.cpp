#include "hsr/scene/leaf_corners.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "geometry/mesh.h"
#include "tests/scenes/test_scene.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// Triangles near one plane, of some the corners within a gap of it, with long thin ones among them; the plane of the first is nearly
/// that.
std::vector<Point3> near_a_plane(std::mt19937_64& random, double gap) {
  const auto unit = [&] { return static_cast<double>(random() % 2000003) / 1000001 - 1; };
  std::vector<Point3> points = {{-1, -1, 0}, {1, -1, gap * unit()}, {0, 1, gap * unit()}};
  for (int k = 0; k < 8; ++k) {
    const double width = k % 2 == 0 ? 1 : 0x1p-12, off = k % 3 == 0 ? 0 : 8 * gap * unit();
    const Point3 at = {unit(), unit(), 0};
    for (int c = 0; c < 3; ++c) points.push_back({at.x + unit(), at.y + width * unit(), off + gap * unit()});
  }
  for (Point3& p : points)  // tilted, so that all coordinates count
    p = {(2 * p.x - p.y + 2 * p.z) / 3, (2 * p.x + 2 * p.y - p.z) / 3, (2 * p.y + 2 * p.z - p.x) / 3};
  return points;
}

bool is_beside(const ProjectedMesh& projected, Predicates& exact, TriangleId t, const Plane& plane) {
  Sign all[3];
  for (std::size_t k = 0; k < 3; ++k) all[k] = exact.side(plane, projected.point(projected.mesh().triangles[t][k]));
  return all[0] != Sign::zero && all[0] == all[1] && all[0] == all[2];
}

}  // namespace

TEST_CASE("what a leaf tells of its triangles and a plane is so, and it tells nearly all", "[scene][leaf_corners][property]") {
  std::mt19937_64 random(23);
  std::size_t told = 0, are = 0;
  for (const View& view : {scenes::from_direction({1, -2, 3}), scenes::from_eye({3, -4, 2}, {0, 0, 0})})
    for (const double gap : {0x1p-4, 0x1p-12, 0x1p-18, 0x1p-24, 0x1p-30, 0x1p-52})
      for (int i = 0; i < 400; ++i) {
        const Mesh mesh = make_mesh(near_a_plane(random, gap), [] {
          std::vector<std::array<std::uint32_t, 3>> all;
          for (std::uint32_t k = 0; k < 27; k += 3) all.push_back({k, k + 1, k + 2});
          return all;
        }());
        if (mesh.triangles.size() != 9) continue;
        const ProjectedMesh projected(mesh, view, Arithmetic::staged);
        std::vector<TriangleId> in_leaf;
        for (std::uint32_t t = 1; t < 9; ++t) in_leaf.emplace_back(t);
        const LeafCorners leaf(projected, in_leaf);
        Predicates exact = projected.predicates();
        const auto& c = mesh.triangles[TriangleId(0)];
        for (const Plane& plane : {projected.face_plane(TriangleId(0)), projected.sight_plane(c[0], c[1])}) {
          const unsigned beside = leaf.beside(LeafPlane(projected.filter(plane)));
          for (std::size_t k = 0; k < in_leaf.size(); ++k) {
            const bool is = is_beside(projected, exact, in_leaf[k], plane), is_told = (beside >> k & 1U) != 0;
            CHECK_FALSE((is_told && !is));
            // Those within the last places of floats are not asked for.
            if (gap < 0x1p-18) continue;
            told += is_told ? 1U : 0U;
            are += is ? 1U : 0U;
          }
        }
      }
  CHECK(are > 5000);
  CHECK(told * 100 > are * 95);
}

TEST_CASE("a leaf tells nothing where filters are not proven, and of triangles that it has not", "[scene][leaf_corners]") {
  std::mt19937_64 random(29);
  const Mesh mesh = make_mesh(near_a_plane(random, 1), std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 4, 5}});
  for (const Arithmetic arithmetic : {Arithmetic::staged, Arithmetic::interval, Arithmetic::rational}) {
    const ProjectedMesh projected(mesh, scenes::from_direction({1, -2, 3}), arithmetic);
    const std::vector<TriangleId> in_leaf = {TriangleId(1)};
    const LeafCorners leaf(projected, in_leaf);
    const unsigned beside = leaf.beside(LeafPlane(projected.filter(projected.face_plane(TriangleId(0)))));
    if (arithmetic != Arithmetic::staged) CHECK((beside & 1U) == 0);
  }
  CHECK(LeafCorners().beside(LeafPlane()) == 0);
}
