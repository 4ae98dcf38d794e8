#include "hsr/check/area_check.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"
#include "hsr/check/error_against_time.h"
#include "hsr/check/error_csv.h"
#include "hsr/check/sample_checks.h"
#include "hsr/raster/caster.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

TEST_CASE("half of each pixel on the diagonal is wrong", "[check][area]") {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const Mesh mesh = scene.mesh();
  const VisibleFragments fragments = visible_fragments(mesh, scene.view);
  // Pixels [i, i + 1] x [3 - j, 4 - j].
  const SampleGrid grid = {{0.5, 3.5, 0}, {1, 0, 0}, {0, -1, 0}, 4, 4};
  const Image<TriangleId> seen = cast(mesh, scene.view, grid).triangles;
  const AreaCheck right = check_area(mesh, scene.view, fragments, grid, seen);
  CHECK(right.visible == 8);
  CHECK(right.wrong == 2);
  CHECK(check_area(mesh, scene.view, fragments, grid, Image<TriangleId>(4, 4)).wrong == 8);
  CHECK(check_area(mesh, scene.view, fragments, grid, Image<TriangleId>(4, 4, TriangleId(0))).wrong == 8);
  // A part of the picture: its corners are cut off.
  const SampleGrid part = {{1.5, 1.5, 0}, {1, 0, 0}, {0, -1, 0}, 2, 2};
  const AreaCheck of_part = check_area(mesh, scene.view, fragments, part, Image<TriangleId>(2, 2, TriangleId(0)));
  CHECK(of_part.visible == 3.5);
  CHECK(of_part.wrong == 0.5);
}

TEST_CASE("visible areas are the exact ones, and wrong areas those of a finer picture", "[check][area][property]") {
  int compared = 0;
  for (const char* name : {"triangles", "boxes", "polygons", "around_the_eye"})
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const scenes::TestScene scene = scenes::family(name).make(seed);
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      const Mesh mesh = scene.mesh();
      const VisibleFragments fragments = visible_fragments(mesh, scene.view);
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 32, 24);
      constexpr int finer = 16;
      SampleGrid fine = grid;
      const double first = (1.0 / finer - 1) / 2;
      fine.width *= finer;
      fine.height *= finer;
      for (const int axis : {0, 1, 2}) {
        double* const o[] = {&fine.origin.x, &fine.origin.y, &fine.origin.z};
        *o[axis] += first * (grid.right[axis] + grid.down[axis]);
      }
      fine.right = {grid.right.x / finer, grid.right.y / finer, grid.right.z / finer};
      fine.down = {grid.down.x / finer, grid.down.y / finer, grid.down.z / finer};
      Image<TriangleId> shown, nearest;
      try {
        std::uint64_t overlapping = 0;
        shown = paint(mesh, scene.view, fragments, grid, overlapping);
        nearest = paint(mesh, scene.view, fragments, fine, overlapping);
      } catch (const PreconditionError&) {
        continue;  // the samples are no doubles, or not where they should be
      }
      const AreaCheck found = check_area(mesh, scene.view, fragments, grid, shown);
      double wrong = 0;
      for (int j = 0; j < fine.height; ++j)
        for (int i = 0; i < fine.width; ++i)
          if (nearest.at(i, j) != shown.at(i / finer, j / finer)) wrong += 1.0 / (finer * finer);
      CHECK(found.wrong == Approx(wrong).epsilon(0.02).margin(2));
      ++compared;
      if (scene.view.is_perspective()) continue;
      const auto length = [](const Point3& p) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z); };
      Rational all;
      for (const Rational& a : visible_areas(mesh, scene.view, fragments)) all = all + a;
      CHECK(found.visible == Approx(all.to_double() / (length(grid.right) * length(grid.down))).epsilon(1e-6));
    }
  CHECK(compared > 50);
}

TEST_CASE("error against time has a line for each size and number, and the exact method at error zero", "[check][area][K2]") {
  const scenes::TestScene scene = scenes::family("boxes").make(3);
  const Mesh mesh = scene.mesh();
  const VisibleFragments fragments = visible_fragments(mesh, scene.view);
  const auto grid = [&](int n) { return sample_grid(scene.view, paper_rectangle(mesh, scene.view), n, n); };
  ErrorAgainstTimeOptions options;
  options.sizes = {16, 64};
  const auto rows = error_against_time(SceneView(mesh, scene.view), fragments, grid, options);
  REQUIRE(rows.size() == 5);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    CHECK(rows[k].area.wrong > 0);
    // With four times as many samples a way a smaller share is wrong.
    CHECK(rows[k + 2].area.wrong / rows[k + 2].area.visible < rows[k].area.wrong / rows[k].area.visible);
  }
  CHECK(rows[4].method == "fragments");
  CHECK(rows[4].area.wrong == 0);
  CHECK(rows[4].samples.samples == 16 * 16 + 64 * 64);
  CHECK(rows[4].samples.wrong == 0);
  CHECK(rows[4].seconds.size() == 3);
  VisibleFragments wrong = fragments;
  wrong.fragments.pop_back();
  CHECK_FALSE(error_against_time(SceneView(mesh, scene.view), wrong, grid, options).back().samples.is_explained());
  const std::string csv = error_csv(rows);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 6);
  CHECK(csv.substr(0, 15) == "method,numbers,");
}

}  // namespace
}  // namespace hsr
