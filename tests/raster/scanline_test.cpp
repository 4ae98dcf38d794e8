#include "hsr/raster/scanline.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"
#include "hsr/check/picture_check.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

std::string row(const Image<TriangleId>& image, const Mesh& mesh, int j) {
  std::string text;
  for (int i = 0; i < image.width; ++i) {
    const TriangleId t = image.at(i, j);
    text += t.is_valid() ? static_cast<char>('a' + mesh.face_of[t].value) : '.';
  }
  return text;
}

constexpr SampleGrid eight_by_two = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, 9, 2};

TEST_CASE("faces are compared only where spans begin", "[image][scanline]") {
  // From above: a wide face, one over its middle, one under it that looks out on the right.
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.add_face(std::vector<Point3>{{0, -1, 0}, {6, -1, 0}, {6, 2, 0}, {0, 2, 0}});
  scene.add_face(std::vector<Point3>{{2, -1, 1}, {4, -1, 1}, {4, 2, 1}, {2, 2, 1}});
  scene.add_face(std::vector<Point3>{{1, -1, -1}, {8, -1, -1}, {8, 2, -1}, {1, 2, -1}});
  const Mesh mesh = scene.mesh();
  const Scanline found = scanline(mesh, scene.view, eight_by_two, depth_sort(mesh, scene.view).order);
  CHECK(row(found.triangles, mesh, 0) == "aabbaacc.");
  CHECK(row(found.triangles, mesh, 1) == "aabbaacc.");
  // A row: a begins; c begins, behind a; b begins, before a; b ends, and a is before c; a ends, and c is left.
  CHECK(found.spans == 2 * 5);
  CHECK(found.depth_comparisons == 2 * 3);
  CHECK(found.most_active == 6);
  CHECK(found.bytes > 0);
}

TEST_CASE("faces that pierce each other are wrong unless they are split first", "[image][scanline]") {
  // A level face, and one that comes up through it from the left, and shows from column 4 on.
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.add_face(std::vector<Point3>{{0, -1, 0}, {8, -1, 0}, {8, 2, 0}, {0, 2, 0}});
  scene.add_face(std::vector<Point3>{{1, -1, -3}, {8, -1, 4}, {8, 2, 4}, {1, 2, -3}});
  const Mesh mesh = scene.mesh();
  const DepthSort sorted = depth_sort(mesh, scene.view);
  CHECK(row(cast(mesh, scene.view, eight_by_two).triangles, mesh, 0) == "aaaabbbb.");
  CHECK(row(scanline(mesh, scene.view, eight_by_two, sorted.order).triangles, mesh, 0) == "aaaabbbb.");
  // Whole: where b begins it is behind a, and nothing asks again before a triangle of a ends: its diagonal, at column 1 or 2
  // of 3 rows, and its right side.
  const std::string whole = row(scanline(mesh, scene.view, eight_by_two).triangles, mesh, 0);
  CHECK(whole == "aaaaaabb.");
}

/// Samples that show a face which is farther than another by more than the last digits of doubles.
std::uint64_t wrong_order(const Mesh& mesh, const View& view, const SampleGrid& grid, const Image<TriangleId>& shown,
                          std::uint64_t* edge = nullptr) {
  const DepthResolution resolution{DepthFormat::float64, depth_range(mesh, view, grid), 0x1p-30};
  const PictureCheck check = check_picture(mesh, view, grid, shown, cast(mesh, view, grid).triangles, resolution);
  if (edge != nullptr) *edge += check.edge;
  return check.order;
}

TEST_CASE("on split faces the scanline algorithm shows the nearest face everywhere", "[image][scanline][property]") {
  std::uint64_t whole_wrong = 0, samples = 0, edge = 0;
  for (const char* family : {"triangles", "polygons", "edge_on", "boxes", "around_the_eye", "echoes"})
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      // What is cut a thousandth of the way before the eye is seen a thousand times as large, and rounding with it.
      if (scene.view.is_perspective() && scene.view.near < 0.1) continue;
      INFO(family << " " << seed << "\n" << scenes::to_text(scene));
      const Mesh mesh = scene.mesh();
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
      const Scanline split = scanline(mesh, scene.view, grid, depth_sort(mesh, scene.view).order);
      CHECK(wrong_order(mesh, scene.view, grid, split.triangles, &edge) == 0);
      samples += split.triangles.pixels.size();
      whole_wrong += wrong_order(mesh, scene.view, grid, scanline(mesh, scene.view, grid).triangles);
    }
  CAPTURE(samples, edge, whole_wrong);
  CHECK(edge < samples / 200);
  CHECK(whole_wrong > 100);
}

TEST_CASE("where no faces pierce, the scanline algorithm shows what the z-buffer does", "[image][scanline][property]") {
  std::uint64_t covered = 0;
  for (const char* family : {"triangles", "polygons", "boxes", "edge_on"})
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      const Mesh mesh = scene.mesh();
      const DepthSort sorted = depth_sort(mesh, scene.view);
      if (sorted.counts.piercing > 0 || sorted.counts.coplanar > 0) continue;
      INFO(family << " " << seed << "\n" << scenes::to_text(scene));
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 40, 30);
      const Scanline found = scanline(mesh, scene.view, grid);
      const DepthImage<double> expected = z_buffer<double>(mesh, scene.view, grid);
      std::size_t different = 0;
      for (std::size_t k = 0; k < expected.pixels.size(); ++k) {
        const TriangleId t = found.triangles.pixels[k];
        // Where triangles meet, rounding may show either.
        if (t != expected.pixels[k].triangle) {
          const double nearness = z_buffer<double>(mesh, scene.view, grid, std::array{t}).pixels[k].nearness;
          different += std::fabs(nearness - expected.pixels[k].nearness) < 0x1p-45 ? 0 : 1;
        }
        covered += expected.pixels[k].triangle.is_valid() ? 1U : 0U;
      }
      CHECK(different == 0);
    }
  CHECK(covered > 10'000);
}

}  // namespace
}  // namespace hsr
