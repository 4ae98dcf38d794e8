#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "geometry/error.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/a_buffer.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

constexpr Colour red = {255, 0, 0, 255}, blue = {0, 0, 255, 255}, black = {0, 0, 0, 255};

/// Seen from above; sample (i, j) is at (i, -j), its pixel half a unit around it.
scenes::TestScene rectangles(const std::vector<std::array<double, 5>>& left_right_top_bottom_height) {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  for (const auto& [left, right, top, bottom, z] : left_right_top_bottom_height)
    scene.add_face(std::vector<Point3>{{left, -bottom, z}, {right, -bottom, z}, {right, -top, z}, {left, -top, z}});
  return scene;
}
SampleGrid pixels(int width, int height) { return {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, width, height}; }

TEST_CASE("the alpha-buffer lays layers over one another by depth, not by order", "[image][alpha_buffer]") {
  for (const bool red_first : {true, false}) {
    const scenes::TestScene scene = rectangles({{-1, 4, -1, 2, red_first ? 2.0 : 1.0}, {1, 4, -1, 2, red_first ? 1.0 : 2.0}});
    // Red is always above, and in one case narrower.
    const std::vector<Colour> colours = red_first ? std::vector{red, blue} : std::vector{blue, red};
    const AlphaBuffer found = alpha_buffer(scene.mesh(), scene.view, pixels(4, 1), colours, 0.5);
    // Half of blue over white, (127.5, 127.5, 255), and half of red over that.
    CHECK(found.picture.at(2, 0) == Colour{191, 64, 128, 255});
    CHECK(found.picture.at(0, 0) == (red_first ? Colour{255, 128, 128, 255} : Colour{128, 128, 255, 255}));
    CHECK(found.layers == 4 + 3);
    CHECK(found.most_layers == 2);
    CHECK(found.bytes > 7 * sizeof(double));
  }
}

TEST_CASE("the A-buffer counts the samples of a mask", "[image][a_buffer]") {
  // Black over 3 of 8 columns of pixel 0, and over 1 of 4 rows of pixel 1.
  const scenes::TestScene scene = rectangles({{-0.5, -0.125, -0.5, 0.5, 0}, {0.5, 1.5, 0.25, 0.5, 0}});
  const ABuffer found = a_buffer(scene.mesh(), scene.view, pixels(2, 1), {black, black}, 1);
  CHECK(found.picture.at(0, 0) == Colour{159, 159, 159, 255});  // 255 * 5 / 8 = 159.375
  CHECK(found.picture.at(1, 0) == Colour{191, 191, 191, 255});  // 255 * 3 / 4 = 191.25
  // The two triangles of a rectangle are one fragment.
  CHECK(found.fragments == 2);
  CHECK(found.most_fragments == 1);
}

TEST_CASE("the A-buffer resolves masks and opacity front to back", "[image][a_buffer]") {
  // Half of red over the left half, over blue over all of the pixel.
  const scenes::TestScene scene = rectangles({{-0.5, 0.5, -0.5, 0.5, 0}, {-0.5, 0, -0.5, 0.5, 1}});
  const Colour half_red = {255, 0, 0, 128};
  const ABuffer found = a_buffer(scene.mesh(), scene.view, pixels(1, 1), {blue, half_red}, 1);
  // Left: 128 / 255 of red and the rest blue; right: blue. The mean: (64, 0, 191).
  CHECK(found.picture.at(0, 0) == Colour{64, 0, 191, 255});
  CHECK(found.fragments == 2);
  // Behind what is opaque and covers the pixel nothing is seen.
  const scenes::TestScene covered = rectangles({{-1, 1, -1, 1, 5}, {-0.5, 0, -0.5, 0.5, 1}});
  CHECK(a_buffer(covered.mesh(), covered.view, pixels(1, 1), {blue, red}, 1).picture.at(0, 0) == blue);
}

std::vector<Colour> random_colours(std::size_t n) {
  std::mt19937_64 random(5);
  std::vector<Colour> colours(n);
  for (Colour& c : colours)
    for (std::uint8_t& x : c) x = static_cast<std::uint8_t>(20 + random() % 230);
  return colours;
}

/// The nearnesses of these triangles at a sample; fewer if rounding loses one.
std::vector<double> depths(const scenes::TestScene& scene, const Mesh& mesh, const SampleGrid& grid, std::size_t pixel,
                           const std::vector<TriangleId>& layers) {
  std::vector<double> found;
  for (const TriangleId t : layers) {
    const DepthPixel<double> p = z_buffer<double>(mesh, scene.view, grid, std::array{t}).pixels[pixel];
    if (p.triangle.is_valid()) found.push_back(p.nearness);
  }
  return found;
}

/// Of planar faces that cross themselves an order paints a place once, and the alpha-buffer each triangle.
bool has_face_twice(const Mesh& mesh, const View& view, const SampleGrid& grid, std::size_t pixel) {
  std::set<FaceId> faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool is_there = z_buffer<double>(mesh, view, grid, std::array{TriangleId(t)}).pixels[pixel].triangle.is_valid();
    if (is_there && !faces.insert(mesh.face_of[TriangleId(t)]).second) return true;
  }
  return false;
}

TEST_CASE("the alpha-buffer has the colours of the painter's order, but for ties", "[image][alpha_buffer][oracle]") {
  std::size_t samples = 0, edge = 0, tied = 0, twice = 0;
  for (const char* family : {"triangles", "polygons", "boxes", "edge_on", "around_the_eye"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      if (scene.view.is_perspective() && scene.view.near < 0.1) continue;
      const Mesh mesh = scene.mesh();
      const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 15, 12);
      const std::vector<Colour> colours = random_colours(mesh.faces.size());
      Image<Colour> expected;
      try {
        expected = paint(mesh, scene.view, depth_sort(mesh, scene.view).order, grid, colours, 0.9);
      } catch (const PreconditionError&) {
        continue;  // the eye in the plane of the samples
      }
      const AlphaBuffer found = alpha_buffer(mesh, scene.view, grid, colours, 0.9);
      const Image<std::vector<TriangleId>> layers = oracle::layers_at_samples(mesh, scene.view, grid);
      samples += expected.pixels.size();
      for (std::size_t k = 0; k < expected.pixels.size(); ++k) {
        if (found.picture.pixels[k] == expected.pixels[k]) continue;
        if (has_face_twice(mesh, scene.view, grid, k)) {
          ++twice;
          continue;
        }
        std::vector<double> z = depths(scene, mesh, grid, k, layers.pixels[k]);
        std::sort(z.begin(), z.end());
        bool is_tied = false;
        for (std::size_t m = 1; m < z.size(); ++m) is_tied = is_tied || z[m] - z[m - 1] < 0x1p-45;
        if (is_tied) {
          ++tied;
          continue;
        }
        INFO(family << " " << seed << " sample " << k << "\n" << scenes::to_text(scene));
        // Then rounding moved an edge over the sample, which lies on it.
        std::size_t edges_there = 0;
        for (const double x : {-0x1p-20, 0x1p-20})
          for (const double y : {-0x1p-20, 0x1p-20}) {
            SampleGrid moved = grid;
            moved.origin = {grid.origin.x + x * grid.right.x + y * grid.down.x,
                            grid.origin.y + x * grid.right.y + y * grid.down.y,
                            grid.origin.z + x * grid.right.z + y * grid.down.z};
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
              const auto covers = [&](const SampleGrid& g) {
                return z_buffer<double>(mesh, scene.view, g, std::array{TriangleId(t)}).pixels[k].triangle.is_valid();
              };
              edges_there += covers(moved) != covers(grid) ? 1U : 0U;
            }
          }
        CHECK(edges_there > 0);
        ++edge;
      }
    }
  CAPTURE(samples, edge, tied, twice);
  CHECK(edge < samples / 100);
  CHECK(tied < samples / 50);
  CHECK(twice < samples / 50);
}

TEST_CASE("the A-buffer has the mean colours of the painter's order at the samples of its masks", "[image][a_buffer][oracle]") {
  std::size_t samples = 0, different = 0;
  int scenes_seen = 0;
  for (const char* family : {"triangles", "polygons", "boxes"})
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      const Mesh mesh = scene.mesh();
      if (scene.view.is_perspective()) continue;
      const DepthSort sorted = depth_sort(mesh, scene.view);
      if (sorted.counts.piercing > 0 || sorted.counts.coplanar > 0) continue;
      // Of samples 16 times as fine every second one each way, and every fourth down.
      const SampleGrid finest = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 16 * 12, 16 * 10);
      const auto moved = [&](double x, double y, double right, double down, int width, int height) {
        const Point3 &o = finest.origin, &r = finest.right, &d = finest.down;
        return SampleGrid{{o.x + x * r.x + y * d.x, o.y + x * r.y + y * d.y, o.z + x * r.z + y * d.z},
                          {right * r.x, right * r.y, right * r.z},
                          {down * d.x, down * d.y, down * d.z},
                          width,
                          height};
      };
      const SampleGrid coarse = moved(7.5, 7.5, 16, 16, 12, 10), fine = moved(0.5, 1.5, 2, 4, 12 * 8, 10 * 4);
      const std::vector<Colour> colours = random_colours(mesh.faces.size());
      Image<Colour> light;
      try {
        light = paint(mesh, scene.view, sorted.order, fine, colours, 0.9);
      } catch (const PreconditionError&) {
        continue;  // samples that are no doubles
      }
      ++scenes_seen;
      const ABuffer found = a_buffer(mesh, scene.view, coarse, colours, 0.9);
      for (int j = 0; j < coarse.height; ++j)
        for (int i = 0; i < coarse.width; ++i) {
          std::array<double, 3> mean = {0, 0, 0};
          for (int v = 0; v < 4; ++v)
            for (int u = 0; u < 8; ++u)
              for (std::size_t k = 0; k < 3; ++k) mean[k] += light.at(8 * i + u, 4 * j + v)[k] / 32.0;
          bool is_same = true;
          for (std::size_t k = 0; k < 3; ++k) is_same = is_same && std::fabs(mean[k] - found.picture.at(i, j)[k]) < 1.01;
          different += is_same ? 0 : 1;
          ++samples;
        }
    }
  CAPTURE(samples, different, scenes_seen);
  CHECK(scenes_seen > 20);
  CHECK(different < samples / 200);
}

}  // namespace
}  // namespace hsr
