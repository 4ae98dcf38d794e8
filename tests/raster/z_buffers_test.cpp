#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "geometry/error.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

template <class Real>
void check_same(const Mesh& mesh, const View& view, const SampleGrid& grid) {
  const DepthImage<Real> plain = z_buffer<Real>(mesh, view, grid);
  CHECK(row_z_buffer<Real>(mesh, view, grid).image == plain);
  CHECK(tiled_z_buffer<Real>(mesh, view, grid).image == plain);
}

/// Of a scene that stretches over several tiles.
void check_same(const scenes::TestScene& scene, int width, int height) {
  const Mesh mesh = scene.mesh();
  SampleGrid grid;
  try {
    grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), width, height);
  } catch (const InputError&) {
    return;  // a picture beyond all doubles
  }
  check_same<float>(mesh, scene.view, grid);
  check_same<double>(mesh, scene.view, grid);
}

TEST_CASE("a buffer of one row and one in tiles show what the plain z-buffer does, to the bit", "[image][z_buffer][property]") {
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      INFO(family.name << " " << seed);
      check_same(family.make(seed), 130, 70);
    }
}

TEST_CASE("the edges of pictures and tiles make no difference", "[image][z_buffer]") {
  const scenes::TestScene scene = scenes::family("triangles").make(3);
  for (const int width : {1, 2, 63, 64, 65, 128, 200})
    for (const int height : {1, 63, 64, 65, 129}) {
      INFO(width << " x " << height);
      check_same(scene, width, height);
    }
}

TEST_CASE("tiles are the same for any number of threads", "[image][z_buffer]") {
  const scenes::TestScene scene = scenes::family("triangles").make(5);
  const Mesh mesh = scene.mesh();
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 700, 500);
  const DepthImage<float> plain = z_buffer<float>(mesh, scene.view, grid);
  for (const std::size_t threads : {1U, 2U, 5U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(tiled_z_buffer<float>(mesh, scene.view, grid).image == plain);
  }
}

/// A square of 16 x 16 units, and of 12 x 12 over it, by two triangles each; a unit is a sample.
scenes::TestScene two_squares() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {16, 0, 0}, {16, 16, 0}, {0, 16, 0}});
  scene.add_face(std::vector<Point3>{{2, 2, 1}, {14, 2, 1}, {14, 14, 1}, {2, 14, 1}});
  return scene;
}
constexpr SampleGrid whole = {{0.5, 15.5, 0}, {1, 0, 0}, {0, -1, 0}, 16, 16};

TEST_CASE("the working storage of a row and of tiles is told", "[image][z_buffer]") {
  const Mesh mesh = two_squares().mesh();
  const View view = two_squares().view;
  const RowZBuffer<float> row = row_z_buffer<float>(mesh, view, whole);
  CHECK(row.most_active == 4);
  CHECK(row.image.at(2, 2).nearness == 1);
  CHECK(row.image.at(1, 1).nearness == 0);
  const TiledZBuffer<float> tiled = tiled_z_buffer<float>(mesh, view, whole);
  CHECK(tiled.entries == 4);
  // 64 x 64 depths and indices of four bytes, for each thread that drew; corners and lists are a few hundred bytes.
  CHECK(tiled.bytes > 64 * 64 * 8);
  CHECK(tiled.bytes < 64 * 64 * 8 + 2000);
  // Eight corners of 12 bytes, 16 depths with indices, buckets of 16 rows and 4 triangles, active triangles.
  CHECK(row.bytes > 8 * 12 + 16 * 8 + 20 * 4);
  CHECK(row.bytes < 2000);
  // What is seen four times as large is in more tiles, and no row has more than four triangles.
  const SampleGrid fine = {{0.0625, 15.9375, 0}, {0.125, 0, 0}, {0, -0.125, 0}, 128, 128};
  CHECK(tiled_z_buffer<float>(mesh, view, fine).entries == 16);
  CHECK(row_z_buffer<float>(mesh, view, fine).most_active == 4);
}

TEST_CASE("the z-buffer of some triangles has only these", "[image][z_buffer]") {
  const Mesh mesh = two_squares().mesh();
  const std::vector<TriangleId> upper = {TriangleId(2), TriangleId(3)};
  const DepthImage<float> image = z_buffer<float>(mesh, two_squares().view, whole, upper);
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) CHECK(image.at(i, j).triangle.is_valid() == (i >= 2 && i < 14 && j >= 2 && j < 14));
}

/// Faces over ten samples of one row, at columns 0 ... 9, higher is nearer.
struct LectureRow {
  scenes::TestScene scene;
  SampleGrid grid = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 10, 1};

  LectureRow() { scene.view = parallel_view({0, 0, 1}, {0, 1, 0}); }
  void add(double left, double right, double at_left, double at_right) {
    scene.add_face(std::vector<Point3>{{left, -1, at_left}, {right, -1, at_right}, {right, 1, at_right}, {left, 1, at_left}});
  }
  std::vector<int> row() const {
    std::vector<int> values;
    for (const auto& pixel : row_z_buffer<float>(scene.mesh(), scene.view, grid).image.pixels)
      values.push_back(pixel.triangle.is_valid() ? static_cast<int>(pixel.nearness) : -1);
    return values;
  }
};

TEST_CASE("the lecture's buffer of one row: -1 at first, and the larger value wins", "[image][z_buffer][lecture]") {
  LectureRow lecture;
  CHECK(lecture.row() == std::vector<int>(10, -1));
  lecture.add(0.5, 6.5, 3, 3);
  CHECK(lecture.row() == std::vector<int>{-1, 3, 3, 3, 3, 3, 3, -1, -1, -1});
  lecture.add(3.5, 8.5, 5, 5);
  CHECK(lecture.row() == std::vector<int>{-1, 3, 3, 3, 5, 5, 5, 5, 5, -1});
  lecture.add(1.5, 8.5, 0.5, 7.5);  // 1 at column 2 ... 7 at column 8
  CHECK(lecture.row() == std::vector<int>{-1, 3, 3, 3, 5, 5, 5, 6, 7, -1});
}

TEST_CASE("the lecture's alpha-buffer of one row keeps the colours behind", "[image][alpha_buffer][lecture]") {
  LectureRow lecture;
  lecture.add(0.5, 6.5, 3, 3);
  lecture.add(3.5, 8.5, 5, 5);
  lecture.add(1.5, 8.5, 0.5, 7.5);
  const auto picture = [&](const std::vector<Colour>& colours, double opacity) {
    return alpha_buffer(lecture.scene.mesh(), lecture.scene.view, lecture.grid, colours, opacity).picture.pixels;
  };
  // Layers: 0 1 2 2 3 3 3 2 2 0, each takes half of the light.
  std::vector<int> greys;
  for (const Colour& c : picture(std::vector<Colour>(3, {0, 0, 0, 255}), 0.5)) greys.push_back(c[0]);
  CHECK(greys == std::vector<int>{255, 128, 64, 64, 32, 32, 32, 64, 64, 255});
  // Opaque, only the nearest counts: the third face from column 7 on.
  const std::vector<Colour> opaque = picture({{1, 0, 0, 255}, {2, 0, 0, 255}, {3, 0, 0, 255}}, 1);
  std::vector<int> shown;
  for (const Colour& c : opaque) shown.push_back(c[0]);
  CHECK(shown == std::vector<int>{255, 1, 1, 1, 2, 2, 2, 3, 3, 255});
}

}  // namespace
}  // namespace hsr
