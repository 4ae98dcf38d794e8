#include "hsr/raster/samples.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "geometry/error.h"
#include "hsr/raster/sample_signs.h"
#include "tests/oracle/exact_vector.h"
#include "tests/raster/aligned_grids.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

using oracle::Q;
using oracle::Vec;

Vec exact_at(const SampleGrid& g, int i, int j) { return Vec(g.origin) + Q(i) * Vec(g.right) + Q(j) * Vec(g.down); }

TEST_CASE("every sample is exactly a double", "[image][samples][property][G2]") {
  for (const scenes::Family& family : scenes::families()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      for (const SampleGrid& g : aligned_grids(scene.mesh(), scene.view))
        for (int j = 0; j <= g.height; ++j)
          for (int i = 0; i <= g.width; ++i) CHECK(Vec(g.at(i, j)) == exact_at(g, i, j));
    }
  }
}

TEST_CASE("samples are in the middle of pixels, rows from the top", "[image][samples][G1]") {
  const View view = parallel_view({0, 0, 1}, {0, 1, 0});
  const SampleGrid g = sample_grid(view, PaperRectangle{0, 8, 0, 4}, 8, 4);
  CHECK(g.origin == Point3{0.5, 3.5, 0});
  CHECK(g.right == Point3{1, 0, 0});
  CHECK(g.down == Point3{0, -1, 0});
  // A part that is higher than the picture decides the size of the pixels.
  CHECK(sample_grid(view, PaperRectangle{0, 8, 0, 8}, 8, 4).right == Point3{2, 0, 0});
  CHECK(sample_grid(view, FrameSize{4, 2}, 8, 4).origin == Point3{-3.5, 1.5, 0});
}

TEST_CASE("samples are within a 16th of a pixel of the frame", "[image][samples][property][G2]") {
  const View view = perspective_view({3, -7, 2.5}, {0.1, 0.2, 0.3}, {0, 0, 1});
  for (const int width : {1, 7, 1000, 4096}) {
    const int height = width / 2 + 1;
    const SampleGrid g = sample_grid(view, FrameSize{1.7, 0.9}, width, height);
    const double pixel = std::max(3.4 / width, 1.8 / height);
    for (const int i : {0, width - 1})
      for (const int j : {0, height - 1}) {
        const double x = (i - (width - 1) / 2.0) * pixel, y = ((height - 1) / 2.0 - j) * pixel;
        const Frame& f = view.frame;
        const Point3 p = g.at(i, j);
        for (int k = 0; k < 3; ++k) CHECK(std::fabs(p[k] - (f.origin[k] + x * f.right[k] + y * f.up[k])) <= pixel / 16);
      }
  }
}

TEST_CASE("pixels are never so small that samples are no doubles", "[image][samples][G2]") {
  const View view = parallel_view({0, 0, 1}, {0, 1, 0}, {0x1p40, 0, 0});
  const SampleGrid g = sample_grid(view, PaperRectangle{0, 0x1p-30, 0, 0x1p-30}, 16, 16);
  CHECK(g.right.x == 0x1p-5);  // 16 units of 2^-9, 2^-50 of the samples
  CHECK(g.bit_range().bits() <= 51);
  CHECK_THROWS_AS(sample_grid(view, PaperRectangle{0, 1, 0, 1}, 0, 16), InputError);
  CHECK_THROWS_AS(sample_grid(view, PaperRectangle{0, HUGE_VAL, 0, 1}, 16, 16), InputError);
}

TEST_CASE("rows above a vertex are counted exactly", "[image][samples][property]") {
  int known = 0, all = 0;
  for (const scenes::Family& family : scenes::families()) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      for (const SampleGrid& g : aligned_grids(mesh, scene.view)) {
        const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged, g.bit_range());
        std::optional<SampleSigns> signs;
        try {
          signs.emplace(projected, g);
        } catch (const PreconditionError&) {
          continue;
        }
        Predicates exact = projected.predicates();
        for (const Edge& edge : mesh.edges) {
          int rows = 0;
          const Vec p(mesh.points[edge.a]), e(scene.view.viewpoint.at);
          const Vec across = cross(Vec(g.right), Vec(g.down));
          const bool is_in_front =
              !scene.view.is_perspective() || sgn(Q(dot(across, p - e) * dot(across, Vec(g.origin) - e))) > 0;
          CHECK(signs->is_in_front(edge.a, exact) == is_in_front);
          if (!is_in_front) continue;
          // p is below row j iff it and the sample (0, j + 1) are on one side of the row's plane.
          for (int j = 0; j < g.height; ++j) {
            const Vec o = exact_at(g, 0, j);
            const Vec n = cross(Vec(g.right), scene.view.is_perspective() ? o - e : e);
            rows += sgn(Q(dot(n, p - o))) * sgn(Q(dot(n, Vec(g.down)))) > 0 ? 1 : 0;
          }
          CHECK(signs->rows_above(edge.a, exact) == rows);
          int columns = 0;
          for (int i = 0; i < g.width; ++i) {
            const Vec o = exact_at(g, i, 0);
            const Vec n = cross(Vec(g.down), scene.view.is_perspective() ? o - e : e);
            columns += sgn(Q(dot(n, p - o))) * sgn(Q(dot(n, Vec(g.right)))) > 0 ? 1 : 0;
          }
          const int certain = certain_count(signs->column_of(projected.point(edge.a)), signs->grid().width);
          CHECK((certain == columns || certain == -1));
          known += certain >= 0 ? 1 : 0;
          ++all;
          CHECK(signs->rows_above(-5, [&](int j) { return exact.side(signs->row_plane(j), projected.point(edge.a)); }) == rows);
        }
      }
    }
  }
  CHECK(known > all / 4);
}

}  // namespace
}  // namespace hsr
