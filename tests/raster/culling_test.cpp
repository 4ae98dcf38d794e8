#include <algorithm>
#include <catch2/catch.hpp>

#include "geometry/error.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/frustum_culling.h"
#include "hsr/raster/importance_culling.h"
#include "hsr/raster/occlusion_culling.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/scene/projected_mesh.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

using Ids = std::vector<std::uint32_t>;

Ids faces(const Mesh& mesh, const std::vector<TriangleId>& triangles) {
  Ids ids;
  for (const TriangleId t : triangles)
    if (ids.empty() || ids.back() != mesh.face_of[t].value) ids.push_back(mesh.face_of[t].value);
  return ids;
}

/// From above, on samples 0 ... 7 each way.
scenes::TestScene seen_from_above() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  return scene;
}
constexpr SampleGrid eight = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 8, 8};
void add_square(scenes::TestScene& scene, double left, double top, double size, double z) {
  scene.add_face(
      std::vector<Point3>{{left, -top - size, z}, {left + size, -top - size, z}, {left + size, -top, z}, {left, -top, z}});
}

TEST_CASE("bounds out of the picture by more than a sample are culled", "[image][culling]") {
  scenes::TestScene scene = seen_from_above();
  add_square(scene, -3, 1, 1.5, 0);  // ends at column -1.5
  add_square(scene, -3, 1, 2.5, 0);  // at -0.5: within a sample
  add_square(scene, 2, 2, 1, 0);
  add_square(scene, 2, 8.5, 1, 0);   // below the last row but one more
  add_square(scene, 9, -9, 100, 0);  // on the right
  add_square(scene, -50, -50, 100, 0);
  const Mesh mesh = scene.mesh();
  const Culled boxes = frustum_culled(mesh, scene.view, eight, {.bounds = Bounds::boxes, .block = 2});
  CHECK(faces(mesh, boxes.kept) == Ids{1, 2, 5});
  CHECK(boxes.culled == 6);
  CHECK(boxes.tests == 6);
  // The sphere around a square of side 1.5 at column -2.25 reaches to -1.19; that of side 1 at row 9 to 8.29; the large one
  // from column 59 to -11.7.
  const Culled spheres = frustum_culled(mesh, scene.view, eight, {.bounds = Bounds::spheres, .block = 2});
  CHECK(faces(mesh, spheres.kept) == Ids{1, 2, 4, 5});
  CHECK(spheres.culled == 4);
  // All together are in the picture.
  CHECK(frustum_culled(mesh, scene.view, eight).culled == 0);
}

TEST_CASE("frustum culling changes no picture", "[image][culling][property]") {
  std::uint64_t culled[2] = {0, 0};
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      SampleGrid grid;
      try {
        // A window onto the middle of the scene.
        const PaperRectangle all = paper_rectangle(mesh, scene.view);
        const double width = all.right - all.left, height = all.top - all.bottom;
        grid = sample_grid(
            scene.view, {all.left + width / 2, all.right - width / 4, all.bottom + height / 2, all.top - height / 4}, 16, 16);
      } catch (const InputError&) {
        continue;
      }
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      const DepthImage<double> expected = z_buffer<double>(mesh, scene.view, grid);
      for (const Bounds bounds : {Bounds::boxes, Bounds::spheres}) {
        const Culled found = frustum_culled(mesh, scene.view, grid, {.bounds = bounds, .block = 1});
        CHECK(z_buffer<double>(mesh, scene.view, grid, found.kept) == expected);
        CHECK(found.kept.size() + found.culled == mesh.triangles.size());
        culled[bounds == Bounds::boxes ? 0 : 1] += found.culled;
      }
    }
  CHECK(culled[0] > 500);
  CHECK(culled[1] > 300);
}

TEST_CASE("front and back are the same in world, eye and projection space", "[image][culling][property]") {
  int zero = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const Sign expected = projected.facing(TriangleId(k));  // the side of its plane that the eye is on
        zero += expected == Sign::zero ? 1 : 0;
        for (const FacingSpace space : {FacingSpace::world, FacingSpace::eye, FacingSpace::projection})
          CHECK(facing(mesh, scene.view, TriangleId(k), space) == expected);
      }
    }
  CHECK(zero > 100);
}

TEST_CASE("of a cube three faces are left, and without the front the other three", "[image][culling]") {
  scenes::TestScene scene;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
      scene.points.push_back({x, y, z});
  // Outward: bottom, top, front, right, back, left.
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    scene.add_face(face);
  const Mesh mesh = scene.mesh();
  for (const View& view : {parallel_view({3, -2, 1}, {0, 0, 1}), perspective_view({3, -2, 4}, {0.5, 0.5, 0.5}, {0, 0, 1})}) {
    CHECK(faces(mesh, facing_culled(mesh, view).kept) == Ids{1, 2, 3});
    CHECK(faces(mesh, facing_culled(mesh, view, Facing::front).kept) == Ids{0, 4, 5});
    const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 32, 32);
    CHECK(z_buffer<float>(mesh, view, grid, facing_culled(mesh, view).kept) == z_buffer<float>(mesh, view, grid));
  }
  // Seen along an axis, four faces are edge-on.
  CHECK(faces(mesh, facing_culled(mesh, parallel_view({0, 0, 1}, {0, 1, 0})).kept) == Ids{1});
}

TEST_CASE("what is behind a large face is culled, and what looks out is not", "[image][culling]") {
  scenes::TestScene scene = seen_from_above();
  add_square(scene, 0, 0, 64, 10);
  for (int k = 0; k < 20; ++k) add_square(scene, 20 + k, 30, 1, k % 5);  // hidden
  add_square(scene, 63, 30, 2, 0);                                       // half of it
  add_square(scene, 30, 10, 2, 11);                                      // before it
  const Mesh mesh = scene.mesh();
  const Culled found = occlusion_culled(mesh, scene.view);
  CHECK(faces(mesh, found.kept) == Ids{0, 21, 22});
  CHECK(found.culled == 40);
}

TEST_CASE("occlusion culling changes no picture", "[image][culling][property]") {
  std::uint64_t culled = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      SampleGrid grid;
      try {
        grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
      } catch (const InputError&) {
        continue;
      }
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      const Culled found = occlusion_culled(mesh, scene.view);
      CHECK(z_buffer<double>(mesh, scene.view, grid, found.kept) == z_buffer<double>(mesh, scene.view, grid));
      culled += found.culled;
    }
  CHECK(culled > 30);
}

TEST_CASE("the tiles that a triangle touches tell whether it is culled", "[image][culling][property]") {
  struct Watch : CullingObserver {
    std::vector<bool> is_hidden, is_culled;
    void tested(const CullingTest& test) override {
      is_hidden.push_back(!test.tiles.empty() &&
                          std::all_of(test.tiles.begin(), test.tiles.end(), [](const auto& t) { return t.hides; }));
      is_culled.push_back(test.is_culled);
    }
  };
  int culled = 0, touching = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      Watch watch;
      occlusion_culled(SceneView(mesh, scene.view), &watch);
      for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
        const FaceId f(k);
        const std::uint32_t first = mesh.first_triangle[f], end = mesh.first_triangle[FaceId(f.value + 1)];
        bool all = first < end;
        for (std::uint32_t t = first; t < end; ++t) all = all && watch.is_hidden[t];
        for (std::uint32_t t = first; t < end; ++t) {
          CHECK((!watch.is_culled[t] || all));
          culled += watch.is_culled[t] ? 1 : 0;
          touching += all ? 1 : 0;
        }
      }
    }
  CHECK(culled > 30);
  CHECK(culled == touching);
}

TEST_CASE("importance culling says what it lost", "[image][culling]") {
  scenes::TestScene scene = seen_from_above();
  add_square(scene, 1, 1, 1, 0);
  add_square(scene, 3, 3, 3, 0);
  add_square(scene, 6, 1, 0.5, 0);
  const Mesh mesh = scene.mesh();
  const ImportanceCulled found = importance_culled(mesh, scene.view, eight, 1.5);
  CHECK(faces(mesh, found.kept) == Ids{1});
  CHECK(found.culled == 4);
  CHECK(found.lost_area == 1.25);
  CHECK(importance_culled(mesh, scene.view, eight, 1).lost_area == 0.25);  // a square of 1 is not smaller than 1
  CHECK(importance_culled(mesh, scene.view, eight, 0.5).culled == 0);
}

}  // namespace
}  // namespace hsr
