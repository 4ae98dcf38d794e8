#include "hsr/raster/z_buffer.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "geometry/predicates.h"
#include "hsr/raster/caster.h"
#include "hsr/scene/projected_mesh.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

template <class Real>
Image<TriangleId> triangles(const DepthImage<Real>& image) {
  Image<TriangleId> result(image.width, image.height);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) result.pixels[k] = image.pixels[k].triangle;
  return result;
}

bool are_coplanar(const Mesh& mesh, TriangleId t, TriangleId g) {
  Predicates exact(bit_range(mesh.points));
  const auto &a = mesh.triangles[t], &b = mesh.triangles[g];
  const Plane plane = Plane::of_face(mesh.points[a[0]], mesh.points[a[1]], mesh.points[a[2]]);
  return std::all_of(b.begin(), b.end(), [&](VertexId v) { return exact.side(plane, mesh.points[v]) == Sign::zero; });
}

/// Where pictures of samples moved by `step` of a pixel each way show the same, the z-buffer does. Returns how many do not.
template <class Real>
int wrong_away_from_edges(const scenes::TestScene& scene, double step) {
  const Mesh mesh = scene.mesh();
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
  const Image<TriangleId> found = triangles(z_buffer<Real>(mesh, scene.view, grid));
  const Image<TriangleId> expected = cast(mesh, scene.view, grid).triangles;
  std::vector<Image<TriangleId>> moved;
  for (const double x : {-step, step})
    for (const double y : {-step, step}) {
      SampleGrid g = grid;
      g.origin = {g.origin.x + x * g.right.x + y * g.down.x, g.origin.y + x * g.right.y + y * g.down.y,
                  g.origin.z + x * g.right.z + y * g.down.z};
      moved.push_back(cast(mesh, scene.view, g).triangles);
    }
  const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
  int wrong = 0;
  for (std::size_t k = 0; k < found.pixels.size(); ++k) {
    const TriangleId t = expected.pixels[k], g = found.pixels[k];
    if (t == g) continue;
    if (std::any_of(moved.begin(), moved.end(), [&](const auto& m) { return m.pixels[k] != t; })) continue;
    if (t.is_valid() && g.is_valid() && are_coplanar(mesh, t, g)) continue;
    if (g.is_valid() && projected.facing(g) == Sign::zero) continue;  // nothing but an edge, which rounding gave a width
    ++wrong;
  }
  return wrong;
}

TEST_CASE("away from edges and ties the z-buffer agrees with the caster", "[image][z_buffer][property]") {
  for (const char* name : {"triangles", "polygons", "boxes", "edge_on", "around_the_eye"}) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = scenes::family(name).make(seed);
      // What is cut a thousandth of the way before the eye is seen a thousand times as large, and rounding with it.
      if (scene.view.is_perspective() && scene.view.near < 0.1) continue;
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      // A power of two, so that the moved samples are doubles.
      CHECK(wrong_away_from_edges<double>(scene, 0x1p-12) == 0);
      CHECK(wrong_away_from_edges<float>(scene, 0x1p-6) == 0);
    }
  }
}

TEST_CASE("the z-buffer has the depth of the nearest, and of equal depths the lowest index", "[image][z_buffer]") {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
  scene.add_face(std::vector<Point3>{{2, 0, 1}, {8, 0, 1}, {2, 8, 1}});
  const SampleGrid grid = {{0, 3, 0}, {1, 0, 0}, {0, -1, 0}, 4, 4};
  const DepthImage<float> image = z_buffer<float>(scene.mesh(), scene.view, grid);
  CHECK(triangles(image) == cast(scene.mesh(), scene.view, grid).triangles);
  CHECK(image.at(0, 0).triangle == TriangleId(0));
  CHECK(image.at(0, 0).nearness == 0);
  CHECK(image.at(2, 0).triangle == TriangleId(2));
  CHECK(image.at(2, 0).nearness == 1);
  CHECK(!image.at(0, 3).triangle.is_valid());
}

}  // namespace
}  // namespace hsr
