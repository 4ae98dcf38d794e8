#include "hsr/raster/rasterizer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "geometry/error.h"
#include "hsr/raster/caster.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/raster/aligned_grids.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// What the rasterizer needs, in one.
struct Setting {
  ProjectedMesh projected;
  SampleSigns signs;
  Rasterizer rasterizer;

  Setting(const Mesh& mesh, const View& view, const SampleGrid& grid, Arithmetic arithmetic = Arithmetic::staged)
      : projected(mesh, view, arithmetic, grid.bit_range()), signs(projected, grid), rasterizer(signs) {}
};

/// Calls f(mesh, view, grid) for some scenes of every family, with samples on vertices and edges.
template <class F>
void for_random_scenes(int count, const F& f) {
  for (const scenes::Family& family : scenes::families()) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(count); ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      INFO(family.name << " " << seed);
      for (const SampleGrid& grid : aligned_grids(mesh, scene.view)) {
        try {
          const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged, grid.bit_range());
          (void)SampleSigns(projected, grid);
        } catch (const PreconditionError&) {
          continue;  // the viewpoint is in the plane of the samples
        }
        f(mesh, scene.view, grid);
      }
    }
  }
}

Image<int> counted(const SampleGrid& grid, std::span<const SampleSpan> spans) {
  Image<int> image(grid.width, grid.height);
  for (const SampleSpan& s : spans)
    for (int i = s.begin; i < s.end; ++i) ++image.at(i, s.row);
  return image;
}

/// A square [0, n]^2 of n^2 cells, each cut along a diagonal; points inside are moved by eighths, less than makes it fold.
/// Heights are random.
Mesh random_sheet(int n, std::uint64_t seed, bool is_flat) {
  std::mt19937_64 engine(seed);
  const auto eighths = [&](int most) { return static_cast<double>(static_cast<int>(engine() % (2U * most + 1)) - most) / 8; };
  std::vector<Point3> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const bool inside = x > 0 && x < n && y > 0 && y < n;
      const double dx = inside ? eighths(2) : 0, dy = inside ? eighths(2) : 0, z = is_flat ? 0 : eighths(16);
      points.push_back({x + dx, y + dy, z});
    }
  Polygons polygons;
  const auto add = [&](std::initializer_list<int> corners) {
    for (const int c : corners) polygons.corners.push_back(static_cast<std::uint32_t>(c));
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x, b = a + 1, d = a + n + 1, c = d + 1;
      if (engine() % 2 == 0) {
        add({a, b, c});
        add({a, c, d});
      } else {
        add({a, b, d});
        add({c, d, b});
      }
    }
  return make_mesh(points, polygons);
}

TEST_CASE("triangles of a sheet cover each sample once, those on edges and vertices included",
          "[image][rasterizer][property][G4]") {
  const int n = 6;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_sheet(n, seed, seed % 2 == 1);
    const View views[] = {parallel_view({0, 0, 1}, {0, 1, 0}), scenes::from_eye({3, 2.5, 16}, {3, 2.5, 0})};
    for (const View& view : views) {
      if (view.is_perspective() && seed % 2 == 0) continue;  // only what is flat covers once from everywhere
      // From (-1, 7) by eighths: samples on all vertices, and on edges; outside, too.
      const SampleGrid grid = {{-1, 7, 0}, {0.125, 0, 0}, {0, -0.125, 0}, 64, 64};
      Setting s(mesh, view, grid);
      Image<int> covered(grid.width, grid.height);
      Image<TriangleId> painted(grid.width, grid.height);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto spans = s.rasterizer.spans(TriangleId(t));
        Rasterizer::paint(painted, spans, TriangleId(t));
        for (const SampleSpan& span : spans)
          for (int i = span.begin; i < span.end; ++i) ++covered.at(i, span.row);
      }
      bool once = true;
      for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
          // Left and upper border in, right and lower out.
          const bool inside = i >= 8 && i < 8 + 8 * n && j >= 8 && j < 8 + 8 * n;
          once = once && covered.at(i, j) == (inside ? 1 : 0);
        }
      CHECK(once);
      CHECK(painted == cast(mesh, view, grid).triangles);
    }
  }
}

TEST_CASE("the samples of a triangle are those where it is seen alone", "[image][rasterizer][oracle]") {
  for_random_scenes(8, [](const Mesh& mesh, const View& view, const SampleGrid& grid) {
    Setting staged(mesh, view, grid), interval(mesh, view, grid, Arithmetic::interval);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Mesh alone = mesh;
      alone.triangles = {mesh.triangles[TriangleId(t)]};
      const Image<TriangleId> expected = oracle::seen_at_samples(alone, view, grid);
      for (Setting* s : {&staged, &interval}) {
        Image<TriangleId> found(grid.width, grid.height);
        Rasterizer::paint(found, s->rasterizer.spans(TriangleId(t)), TriangleId(0));
        CHECK(found == expected);
      }
    }
  });
}

TEST_CASE("a polygon has the samples of its triangles, holes left out", "[image][rasterizer][property]") {
  int polygons = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::TestScene scene = scenes::family("polygons").make(seed);
    const Mesh mesh = scene.mesh();
    std::vector<bool> is_used(mesh.points.size(), false);
    for (const Edge& e : mesh.edges) is_used[e.a.value] = is_used[e.b.value] = true;
    for (const SampleGrid& grid : aligned_grids(mesh, scene.view)) {
      std::optional<Setting> s;
      try {
        s.emplace(mesh, scene.view, grid);
      } catch (const PreconditionError&) {
        continue;
      }
      for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
        if (mesh.faces[FaceId(f)] != FaceUse::planar) continue;
        const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
        if (first == end || s->projected.facing(TriangleId(first)) == Sign::zero) continue;
        Image<int> expected(grid.width, grid.height);
        bool usable = true;
        std::vector<RasterSide> of_triangles;
        for (std::size_t t = first; t < end; ++t) {
          for (const VertexId v : mesh.triangles[TriangleId(t)])
            usable = usable && s->signs.is_in_front(v, s->rasterizer.exact()) && s->projected.beyond_near(v) != Sign::negative;
          if (!usable) break;
          s->rasterizer.append_sides(TriangleId(t), of_triangles);
          for (const SampleSpan& span : s->rasterizer.spans(TriangleId(t)))
            for (int i = span.begin; i < span.end; ++i) ++expected.at(i, span.row);
        }
        // The tip of a spike is no vertex of the faces as used.
        const auto corners = scene.polygons[f];
        for (const std::uint32_t c : corners) usable = usable && is_used[mesh.merged[VertexId(c)].value];
        if (!usable) continue;
        ++polygons;
        // The ring, keyhole and all; and all sides of the triangles: those inside cancel.
        std::vector<RasterSide> ring;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const VertexId a = mesh.merged[VertexId(corners[k])], b = mesh.merged[VertexId(corners[(k + 1) % corners.size()])];
          if (a == b) continue;
          const auto [top, bottom] =
              std::minmax({s->signs.rows_above(a, s->rasterizer.exact()), s->signs.rows_above(b, s->rasterizer.exact())});
          ring.push_back({ViewPlane::of(s->projected.sight_plane(a, b)), top, bottom});
        }
        CHECK(counted(grid, s->rasterizer.spans(ring)) == expected);
        CHECK(counted(grid, s->rasterizer.spans(of_triangles)) == expected);
      }
    }
  }
  CHECK(polygons > 100);
}

TEST_CASE("a square with a square hole, by hand", "[image][rasterizer]") {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.points = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}, {1, 1, 0}, {4, 1, 0}, {4, 4, 0}, {1, 4, 0}};
  scene.add_face({0, 1, 2, 3});
  scene.add_face({4, 5, 6, 7});
  const Mesh mesh = scene.mesh();
  const SampleGrid grid = {{0, 5, 0}, {1, 0, 0}, {0, -1, 0}, 7, 7};
  Setting s(mesh, scene.view, grid);
  std::vector<RasterSide> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) s.rasterizer.append_sides(TriangleId(t), sides);
  const auto spans = s.rasterizer.spans(sides);
  const std::vector<SampleSpan> expected = {{0, 0, 5}, {1, 0, 1}, {1, 4, 5}, {2, 0, 1},
                                            {2, 4, 5}, {3, 0, 1}, {3, 4, 5}, {4, 0, 5}};
  CHECK(std::vector<SampleSpan>(spans.begin(), spans.end()) == expected);
}

TEST_CASE("sides that pass beside the picture count, too", "[image][rasterizer]") {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  // A needle that is nearly parallel to the rows, and 2^40 wide; the picture is within it, and beside it.
  scene.points = {{-0x1p40, -1, 0}, {0x1p40, 1, 0}, {0x1p40, 2, 0}, {-0x1p40, 0.5, 0}};
  scene.add_face({0, 1, 2});
  scene.add_face({0, 2, 3});
  const Mesh mesh = scene.mesh();
  for (const double x : {0.0, 0x1p39, -0x1p39, 0x1p41, -0x1p41}) {
    const SampleGrid grid = {{x, 4, 0}, {1, 0, 0}, {0, -0.25, 0}, 16, 24};
    for (const Arithmetic arithmetic : {Arithmetic::staged, Arithmetic::interval}) {
      Setting s(mesh, scene.view, grid, arithmetic);
      Image<TriangleId> found(grid.width, grid.height);
      for (const std::size_t t : {0U, 1U}) Rasterizer::paint(found, s.rasterizer.spans(TriangleId(t)), TriangleId(t));
      CHECK(found == oracle::seen_at_samples(mesh, scene.view, grid));
    }
  }
}

TEST_CASE("a side that is a hair off a row, and crosses it beside the picture", "[image][rasterizer]") {
  // Steps (x, y) along a row; x v - y u = 1 for some multiple of it and a little more, which doubles cannot tell from 0.
  const std::int64_t x = (std::int64_t{1} << 30) + 1, y = (std::int64_t{1} << 29) + 5;
  std::int64_t u = 0, v = 1;
  {
    std::int64_t r = x, next_r = y, s = 1, next_s = 0, t = 0, next_t = 1;
    while (next_r != 0) {
      const std::int64_t q = r / next_r;
      r = std::exchange(next_r, r - q * next_r);
      s = std::exchange(next_s, s - q * next_s);
      t = std::exchange(next_t, t - q * next_t);
    }
    REQUIRE(r == 1);
    v = s, u = -t;
  }
  REQUIRE(x * v - y * u == 1);
  const SampleGrid grid = {{0, 0, 0},
                           {static_cast<double>(x), static_cast<double>(y), 0},
                           {static_cast<double>(y), static_cast<double>(-x), 0},
                           16,
                           8};
  for (const int start : {-5, 20})
    for (const int length : {-60, -40, 40, 60})
      for (const int turn : {-1, 1}) {
        scenes::TestScene scene;
        scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
        const Point3 a = grid.at(start, 4);
        const Point3 b = {a.x + static_cast<double>(turn * u + length * x), a.y + static_cast<double>(turn * v + length * y),
                          0};
        scene.points = {a, b, grid.at(8, 1), grid.at(8, 7)};
        scene.add_face({0, 1, 2});
        scene.add_face({0, 3, 1});
        const Mesh mesh = scene.mesh();
        Setting s(mesh, scene.view, grid);
        Image<TriangleId> found(grid.width, grid.height);
        for (const std::size_t t : {0U, 1U}) Rasterizer::paint(found, s.rasterizer.spans(TriangleId(t)), TriangleId(t));
        CHECK(found == oracle::seen_at_samples(mesh, scene.view, grid));
      }
}

}  // namespace
}  // namespace hsr
