#include "hsr/painter/sort/clusters.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "hsr/painter/sort/depth_sort.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

using scenes::TestScene;

/// Two random triangles in each cell of a grid; the cells are one apart, and as large.
TestScene cells(std::array<int, 3> counts, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  TestScene scene;
  for (int i = 0; i < counts[0]; ++i)
    for (int j = 0; j < counts[1]; ++j)
      for (int k = 0; k < counts[2]; ++k)
        for (int n = 0; n < 2; ++n) {
          std::vector<Point3> corners;
          const auto within = [&](int cell) { return 2 * cell + static_cast<double>(random() % 17) / 16; };
          for (int c = 0; c < 3; ++c) corners.push_back({within(i), within(j), within(k)});
          scene.add_face(corners);
        }
  return scene;
}

/// From beyond a corner, from along an axis, from in a slab of cells, from between two, from the plane where one ends.
std::vector<View> views() {
  std::vector<View> all;
  for (const Point3& d : {Point3{1, 2, 3}, {-1, 2, -3}, {0, 0, 1}, {0, -1, 0}, {1, -1, 0}, {-3, -1, 1}})
    all.push_back(scenes::from_direction(d));
  for (const Point3& eye :
       {Point3{-7, -5, 9}, {2.5, -4, 1.5}, {3.5, 1.5, 9}, {3, 1.75, 0.5}, {2.5, 2.5, 3.5}, {4, 3, 2}, {20, 1, 1}})
    all.push_back(scenes::from_eye(eye, {2.25, 1.25, 1}));
  return all;
}

TEST_CASE("Every piece is in one cluster", "[painter][clusters]") {
  TestScene scene = cells({4, 3, 2}, 1);
  for (const View& view : views()) {
    const Mesh mesh = scene.mesh();
    const ProjectedMesh projected(mesh, view, Arithmetic::staged);
    const FacePieces pieces = face_pieces(projected);
    const Clusters found = clusters(projected, pieces);
    std::vector<std::uint32_t> all = found.values();
    std::sort(all.begin(), all.end());
    REQUIRE(all.size() == pieces.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) CHECK(all[i] == i);
    CHECK(found.values().size() == all.size());
    for (std::size_t c = 0; c < found.size(); ++c) {
      CHECK(!found[c].empty());
      CHECK(std::is_sorted(found[c].begin(), found[c].end()));
    }
    if (!projected.is_perspective()) CHECK(found.size() > 3);
  }
}

TEST_CASE("Clusters come from far to near for every eye", "[painter][clusters][oracle]") {
  for (const std::array<int, 3>& counts : {std::array<int, 3>{9, 1, 1}, {1, 9, 1}, {1, 1, 9}, {4, 3, 1}, {3, 2, 2}})
    for (const View& view : views()) {
      TestScene scene = cells(counts, 7);
      scene.view = view;
      const Mesh mesh = scene.mesh();
      const DepthSort sorted = depth_sort(mesh, view);
      INFO(scenes::to_text(scene));
      CHECK(oracle::wrong_with_order(mesh, view, sorted.order) == std::vector<std::string>{});
    }
}

TEST_CASE("Faces that touch a plane from both sides stay together", "[painter][clusters]") {
  // Two walls in one plane, of coplanar faces, of which the lower index is shown; and a row of others to have enough.
  TestScene scene = cells({1, 9, 1}, 3);
  for (const double y : {0.0, 2.0, 4.0}) {
    scene.add_face({Point3{5, y, 0}, {5, y + 1, 0}, {5, y, 1}});
    scene.add_face({Point3{5, y, 0}, {5, y + 1, 0}, {5, y + 1, 1}});
  }
  for (const Point3& eye : {Point3{9, 2, 0.5}, {-9, 2, 0.5}}) {
    scene.view = scenes::from_eye(eye, {5, 2.125, 0.5});
    const Mesh mesh = scene.mesh();
    const DepthSort sorted = depth_sort(mesh, scene.view);
    CHECK(sorted.counts.clusters > 1);
    CHECK(sorted.counts.coplanar == 3);
    CHECK(oracle::wrong_with_order(mesh, scene.view, sorted.order) == std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace hsr
