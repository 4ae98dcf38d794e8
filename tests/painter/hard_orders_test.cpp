#include <tbb/global_control.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <thread>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/caster.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/scenes/random_scenes.h"

// Scenes that are hard to paint, with the answers that a reader can work out by hand.

namespace hsr {

using namespace internal;

namespace {

using scenes::TestScene;

TestScene from_above() {
  TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  return scene;
}

DepthSort sorted(const TestScene& scene) {
  const Mesh mesh = scene.mesh();
  DepthSort result = depth_sort(mesh, scene.view);
  CHECK(oracle::wrong_with_order(mesh, scene.view, result.order) == std::vector<std::string>{});
  CHECK(oracle::wrong_with_order(mesh, scene.view, BspTree(mesh).order(scene.view)) == std::vector<std::string>{});
  return result;
}

/// Triangles around a ring: each starts above the one before and ends below the one after.
TestScene slats(int n) {
  TestScene scene = from_above();
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n, b = 2 * std::numbers::pi * (k + 1.5) / n;
    const auto corner = [](double angle, double radius, double z) {
      return Point3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    scene.add_face({corner(a, 9, 1), corner(a, 10, 1), corner(b, 9.5, 0)});
  }
  return scene;
}

TEST_CASE("slats that overlap in a circle are cut once", "[painter][hard][P8]") {
  for (const int n : {5, 12}) {
    const DepthSort result = sorted(slats(n));
    CHECK(result.counts.cyclic_components == 1);
    CHECK(result.counts.cuts_in_cycles == 1);
    CHECK(result.order.pieces.size() == static_cast<std::size_t>(n) + 1);
    REQUIRE(result.cycles.size() == 1);
    CHECK(result.cycles.front().facets.size() == static_cast<std::size_t>(n));
  }
}

TEST_CASE("a thousand slats in a circle are cut once", "[painter][hard]") {
  const TestScene scene = slats(1000);
  const DepthSort result = depth_sort(scene.mesh(), scene.view);
  CHECK(result.counts.largest_component == 1000);
  CHECK(result.counts.cuts_in_cycles == 1);
  CHECK(result.order.pieces.size() == 1001);
}

TEST_CASE("three triangles, each over the next, are cut once", "[painter][hard]") {
  TestScene scene = from_above();
  for (int k = 0; k < 3; ++k) {
    const double a = 2 * std::numbers::pi * k / 3, c = std::cos(a), s = std::sin(a);
    const auto turned = [&](double x, double y, double z) { return Point3{c * x - s * y, s * x + c * y, z}; };
    scene.add_face({turned(-3, 0.5, 0), turned(-3, 1.0, 0), turned(3, 0.75, 2)});
  }
  const DepthSort result = sorted(scene);
  CHECK(result.counts.cuts_in_cycles == 1);
  CHECK(result.order.pieces.size() == 4);
}

TEST_CASE("faces in no cycle stay whole", "[painter][hard][P5]") {
  TestScene scene = from_above();
  for (int k = 0; k < 20; ++k)
    scene.add_face({{0.0 + k, 0, 0.5 * k}, {3.0 + k, 0, 0.5 * k}, {3.0 + k, 3, 0.5 * k}, {0.0 + k, 3, 0.5 * k}});
  const DepthSort result = sorted(scene);
  CHECK(result.order.pieces.size() == 20);
  CHECK(result.order.pieces.front().facet == FacetId(0));
  CHECK(result.counts.cuts_in_cycles == 0);
}

TEST_CASE("touching and abutting faces are in no cycle", "[painter][hard][P6]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {2, 0, 1}, {2, 2, 1}, {0, 2, 0}});
  scene.add_face({{2, 0, 1}, {4, 0, 0}, {4, 2, 0}, {2, 2, 1}});  // shares a side
  scene.add_face({{4, 0, 3}, {6, 0, 3}, {6, 2, 3}, {4, 2, 3}});  // only as seen
  scene.add_face({{1, 2, 5}, {3, 2, 5}, {2, 4, 5}});
  const DepthSort result = sorted(scene);
  CHECK(result.counts.overlapping == 0);
  CHECK(result.order.pieces.size() == 4);
}

TEST_CASE("of coplanar faces the higher is painted first", "[painter][hard][P2]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  scene.add_face({{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}});
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const DepthSort result = sorted(scene);
  REQUIRE(result.order.pieces.size() == 3);
  CHECK(result.order.pieces[0].facet == FacetId(4));
  CHECK(result.order.pieces[1].facet == FacetId(2));
  CHECK(result.order.pieces[2].facet == FacetId(0));
}

TEST_CASE("squares that pierce each other are cut once", "[painter][hard][P7][P8]") {
  TestScene scene = from_above();
  scene.add_face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  scene.add_face({{-1, -1, -1}, {-1, 1, -1}, {1, 1, 1}, {1, -1, 1}});
  const DepthSort result = sorted(scene);
  CHECK(result.counts.piercing == 1);
  CHECK(result.counts.cuts_at_intersections == 1);
  CHECK(result.order.pieces.size() == 3);
  int split = 0;
  for (const PieceCorner& c : result.order.corners) split += c.original ? 0 : 1;
  CHECK(split == 2);  // the cut, on both of its sides, is no line
}

/// Triangles around the origin, each in a plane of its own: nearly every two pierce each other.
TestScene tangle(int n) {
  TestScene scene = from_above();
  for (int k = 0; k < n; ++k) {
    const double x = 9 - k, y = k * k % 11 - 5, z = k * k * k % 13 - 6;
    scene.add_face({{x, y, z}, {-y - 1, x + 3, -z - 2}, {-x + y, -x - y, 1 - z / 2}});
  }
  return scene;
}

TEST_CASE("where every face pierces many, planes cut them from the start", "[painter][hard][P9]") {
  constexpr int n = 14;
  TestScene scene = tangle(n);
  scene.add_face({{38, -2, 0}, {42, -2, 0}, {42, 2, 0}, {38, 2, 0}});
  scene.add_face({{39, -1, -1}, {39, 1, -1}, {41, 1, 1}, {41, -1, 1}});
  const DepthSort result = sorted(scene);
  CHECK(result.counts.piercing > 4 * n + 1);
  CHECK(result.counts.cuts_at_intersections == 1);  // of the two squares that are no part of the tangle
  CHECK(result.counts.largest_component >= n - 2);
  const Mesh mesh = scene.mesh();
  CHECK(result.order.pieces.size() < 2 * BspTree(mesh).order(scene.view).pieces.size());
}

TEST_CASE("a tangle is refused with its bound, and left when asked to stop", "[painter][hard]") {
  const TestScene scene = tangle(14), large = tangle(200);
  const Mesh mesh = scene.mesh(), large_mesh = large.mesh();
  CHECK_THROWS_WITH(depth_sort(mesh, scene.view, {.most_pieces = 40}),
                    "depth sort: this scene takes more than 40 pieces, expected fewer");
  std::stop_source stop;
  std::thread asks([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop.request_stop();
  });
  CHECK_THROWS_AS(depth_sort(large_mesh, large.view, {.most_pieces = 50'000'000, .stop = stop.get_token()}), CancelledError);
  asks.join();
}

TEST_CASE("a split piece keeps its lines", "[painter][hard][P5][P7]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}});  // not convex: three triangles
  const DepthSort result = sorted(scene);
  CHECK(result.order.pieces.size() == 3);
  int original = 0;
  for (const PieceCorner& c : result.order.corners) original += c.original ? 1 : 0;
  CHECK(original == 5);
}

TEST_CASE("a cycle that no parallel view has", "[painter][hard]") {
  // Three bars around an eye that looks between them.
  TestScene scene;
  scene.view = scenes::from_eye({0, 0, 4}, {0, 0, 0});
  for (int k = 0; k < 3; ++k) {
    const double a = 2 * std::numbers::pi * k / 3, c = std::cos(a), s = std::sin(a);
    const auto turned = [&](double x, double y, double z) { return Point3{c * x - s * y, s * x + c * y, z}; };
    scene.add_face({turned(-3, 0.5, 0), turned(-3, 1.0, 0), turned(2, 0.75, 1)});
  }
  sorted(scene);
}

TEST_CASE("slivers on a paraboloid: no cut by depth, and a BSP is refused with its bound", "[painter][hard]") {
  // Thin triangles along two families of lines of the saddle z = x y, one just above the other.
  TestScene scene = from_above();
  constexpr int n = 60;
  for (int k = 0; k < n; ++k) {
    const double x = -1 + 2.0 * k / n;
    scene.add_face({{x, -1, -x}, {x, 1, x}, {x + 1e-4, 0, 0}});
    scene.add_face({{-1, x, -x + 0.01}, {1, x, x + 0.01}, {0, x + 1e-4, 0.01}});
  }
  const Mesh mesh = scene.mesh();
  const DepthSort result = depth_sort(mesh, scene.view);
  CHECK(result.counts.cuts_in_cycles + result.counts.cuts_at_intersections == 0);
  CHECK(result.order.pieces.size() == 2 * n);
  BspOptions few;
  few.most_pieces = 300;
  CHECK_THROWS_AS(BspTree(mesh, few), InputError);
}

TEST_CASE("a sphere is no depth to recurse to", "[painter][hard]") {
  TestScene scene;
  scene.view = scenes::from_direction({1, 2, 3});
  constexpr std::uint32_t n = 160, m = 320;  // 102 400 triangles
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k < m; ++k) {
      const double a = std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / m;
      scene.points.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < m; ++k) {
      const std::uint32_t p = i * m + k, q = i * m + (k + 1) % m;
      scene.add_face({p, q, q + m});
      scene.add_face({p, q + m, p + m});
    }
  const Mesh mesh = scene.mesh();
  const DepthSort result = depth_sort(mesh, scene.view);
  CHECK(result.counts.cuts_in_cycles == 0);
  CHECK(BspTree(mesh).depth() < 200);
}

/// The painting by both methods shows the nearest face at every sample, and hsr verify has nothing to say.
DepthSort checked(const TestScene& scene) {
  const Mesh mesh = scene.mesh();
  DepthSort result = depth_sort(mesh, scene.view);
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 200, 200);
  for (const PaintersOrder& order : {result.order, BspTree(mesh).order(scene.view)}) {
    CHECK(check_order(mesh, scene.view, order, grid).wrong == 0);
    CHECK(oracle::wrong_with_order(mesh, scene.view, order) == std::vector<std::string>{});
  }
  return result;
}

TEST_CASE("what comes before its turn by depth comes after all that is behind it", "[painter][hard]") {
  // Ramp, leaf, leaf: by the middles of their depths in this order, but the upper leaf is behind the high end of the ramp and
  // before the lower leaf, which the ramp does not overlap.
  for (const int copies : {1, 30}) {  // few pieces have no tree of boxes
    TestScene scene = from_above();
    for (int k = 0; k < copies; ++k) {
      const double y = 3 * k, z = k;
      scene.add_face({Point3{0, y, z}, Point3{10, y - 1, z + 10}, Point3{10, y + 1, z + 10}});
      scene.add_face({Point3{9, y, z + 7}, Point3{11, y - 1, z + 7}, Point3{11, y + 1, z + 7}});
      scene.add_face({Point3{10.2, y, z + 6}, Point3{12, y - 1, z + 6}, Point3{12, y + 1, z + 6}});
    }
    // Below all, so that no plane parts them.
    const double far = 3 * copies;
    scene.add_face({Point3{-50, -50, -60}, Point3{50, -50, -60}, Point3{0, 2 * far + 50, far}});
    const DepthSort result = checked(scene);
    CHECK(result.counts.clusters == 1);
    CHECK(result.counts.by_depth >= static_cast<std::uint64_t>(copies));  // they were compared
    REQUIRE(result.order.pieces.size() == static_cast<std::size_t>(3 * copies + 1));
    std::vector<std::size_t> place(result.order.pieces.size());
    for (std::size_t k = 0; k < place.size(); ++k) place[result.order.pieces[k].facet.value] = k;
    for (std::size_t k = 0; k + 3 < place.size(); k += 3) {
      CHECK(place[k + 2] < place[k + 1]);
      CHECK(place[k + 1] < place[k]);
    }
  }
}

/// A rectangle with corners u and v of a plane with axes i and k; the third axis is at h.
void add_rectangle(TestScene& scene, int i, int k, std::array<double, 4> r, double h) {
  const auto at = [&](double x, double y) {
    std::array<double, 3> p = {h, h, h};
    p[static_cast<std::size_t>(i)] = x;
    p[static_cast<std::size_t>(k)] = y;
    return Point3{p[0], p[1], p[2]};
  };
  scene.add_face({at(r[0], r[2]), at(r[1], r[2]), at(r[1], r[3]), at(r[0], r[3])});
}

TEST_CASE("Borromean rings", "[painter][hard]") {
  // Three flat frames, 10 by 6 outside and 8 by 4 inside, each through the next: no two of them are linked.
  for (const Point3 direction : {Point3{1, 2, 3}, Point3{-5, 3, 2}, Point3{1, 1, 1}}) {
    TestScene scene;
    scene.view = scenes::from_direction(direction);
    for (int axis = 0; axis < 3; ++axis) {
      const int i = axis, k = (axis + 1) % 3;
      for (const double side : {-1.0, 1.0}) {
        add_rectangle(scene, i, k, {side * 4, side * 5, -3, 3}, 0);
        add_rectangle(scene, i, k, {-4, 4, side * 2, side * 3}, 0);
      }
    }
    const DepthSort result = checked(scene);
    CHECK(result.counts.cuts_at_intersections == 0);
    CHECK(result.order.pieces.size() == 12 + result.counts.cuts_in_cycles);
    // A bar passes through another frame, and no four of them lie in a circle.
    CHECK(result.counts.cuts_in_cycles == 0);
  }
}

TEST_CASE("a plain weave is cut at most once for each of its holes", "[painter][hard]") {
  constexpr int n = 6;
  TestScene bent = from_above();
  for (const bool is_warp : {false, true})
    for (int k = 0; k < n; ++k)
      for (int m = 0; m + 1 < n; ++m) {
        // From the middle of one crossing to that of the next: up at one, down at the other.
        const auto z = [&](int at) { return (k + at) % 2 == (is_warp ? 1 : 0) ? 1.0 : 0.0; };
        const double a = m, b = m + 1, low = k - 0.3, high = k + 0.3;
        if (is_warp)
          bent.add_face({Point3{low, a, z(m)}, Point3{high, a, z(m)}, Point3{high, b, z(m + 1)}, Point3{low, b, z(m + 1)}});
        else
          bent.add_face({Point3{a, low, z(m)}, Point3{b, low, z(m + 1)}, Point3{b, high, z(m + 1)}, Point3{a, high, z(m)}});
      }
  const DepthSort of_bent = checked(bent);
  // Around each hole four pieces of bands lie in a circle, and neighbouring holes share one.
  CHECK(of_bent.counts.cuts_in_cycles <= (n - 1) * (n - 1));
  CHECK(2 * of_bent.counts.cuts_in_cycles >= (n - 1) * (n - 1));  // and no cut serves more than two
  CHECK(of_bent.counts.cuts_at_intersections == 0);

  // Two bands each way, tilted: each is over one and under the other. Four in a circle: one cut.
  TestScene straight = from_above();
  for (const double at : {0.0, 2.0}) {
    const double up = at == 0 ? 1 : -1;
    straight.add_face({Point3{-1, at, -up}, Point3{3, at, up}, Point3{3, at + 1, up}, Point3{-1, at + 1, -up}});
    straight.add_face({Point3{at, -1, up}, Point3{at, 3, -up}, Point3{at + 1, 3, -up}, Point3{at + 1, -1, up}});
  }
  const DepthSort of_straight = checked(straight);
  CHECK(of_straight.counts.cuts_in_cycles == 1);
  CHECK(of_straight.order.pieces.size() == 5);
}

TEST_CASE("a spiral stair around a column", "[painter][hard]") {
  for (const Point3 direction : {Point3{3, 1, 2}, Point3{1, -2, 0.5}, Point3{0, 0, 1}}) {
    TestScene scene;
    scene.view = scenes::from_direction(direction);
    const auto at = [](double turn, double radius, double z) {
      const double a = 2 * std::numbers::pi * turn;
      return Point3{radius * std::cos(a), radius * std::sin(a), z};
    };
    constexpr int sides = 12, steps = 40;
    for (int k = 0; k < sides; ++k) {
      const double a = 1.0 * k / sides, b = 1.0 * (k + 1) / sides;
      scene.add_face({at(a, 1, 0), at(b, 1, 0), at(b, 1, 11), at(a, 1, 11)});
      scene.add_face({at(a, 1, 11), at(b, 1, 11), Point3{0, 0, 11}});
    }
    for (int k = 0; k < steps; ++k) {
      // A slab from the column outward: top, bottom, front, back and end.
      const double a = 1.0 * k / 16, b = 1.0 * (k + 1) / 16, z = 0.25 * k, t = z + 0.2;
      scene.add_face({at(a, 1.1, t), at(a, 4, t), at(b, 4, t), at(b, 1.1, t)});
      scene.add_face({at(a, 1.1, z), at(b, 1.1, z), at(b, 4, z), at(a, 4, z)});
      scene.add_face({at(a, 1.1, z), at(a, 4, z), at(a, 4, t), at(a, 1.1, t)});
      scene.add_face({at(b, 1.1, z), at(b, 1.1, t), at(b, 4, t), at(b, 4, z)});
      scene.add_face({at(a, 4, z), at(b, 4, z), at(b, 4, t), at(a, 4, t)});
    }
    const Mesh mesh = scene.mesh();
    const DepthSort result = depth_sort(mesh, scene.view);
    CHECK(result.counts.cuts_at_intersections == 0);
    const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 200, 200);
    CHECK(check_order(mesh, scene.view, result.order, grid).wrong == 0);
    CHECK(check_order(mesh, scene.view, BspTree(mesh).order(scene.view), grid).wrong == 0);
  }
}

TEST_CASE("any number of threads and one tree give the same orders", "[painter][hard]") {
  TestScene scene;
  scene.view = scenes::from_direction({1, 2, 3});
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TestScene part = scenes::family("triangles").make(seed);
    for (std::size_t f = 0; f < part.polygons.size(); ++f) {
      std::vector<Point3> corners;
      for (const std::uint32_t c : part.polygons[f])
        corners.push_back({part.points[c].x + static_cast<double>(seed % 8), part.points[c].y, part.points[c].z});
      scene.add_face(corners);
    }
  }
  const Mesh mesh = scene.mesh();
  const auto same = [](const PaintersOrder& a, const PaintersOrder& b) {
    bool equal = a.pieces.size() == b.pieces.size() && a.corners.size() == b.corners.size();
    for (std::size_t k = 0; equal && k < a.corners.size(); ++k)
      equal = a.corners[k].vertex == b.corners[k].vertex && a.corners[k].a == b.corners[k].a &&
              a.corners[k].b == b.corners[k].b && a.corners[k].side == b.corners[k].side &&
              a.corners[k].original == b.corners[k].original;
    return equal;
  };
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return std::pair(depth_sort(mesh, scene.view).order, BspTree(mesh).order(scene.view));
  };
  const auto one = with(1), two = with(2);
  CHECK(same(one.first, two.first));
  CHECK(same(one.second, two.second));
}

TEST_CASE("the middle of a face is a bad key", "[painter][hard][P12]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  scene.add_face(
      {{0, 0, 1}, {9, 0, -9}, {9, 1, -9}, {0, 1, 1}});  // its middle and its end are farther, but it is before the other
  const Mesh mesh = scene.mesh();
  CHECK_FALSE(oracle::wrong_with_order(mesh, scene.view, z_sort(mesh, scene.view, DepthKey::centroid)).empty());
  CHECK_FALSE(oracle::wrong_with_order(mesh, scene.view, z_sort(mesh, scene.view, DepthKey::farthest_vertex)).empty());
  sorted(scene);
}

TEST_CASE("transparent faces are composited layer by layer", "[painter][hard][P3]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}});  // in front, and first in the file
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const Mesh mesh = scene.mesh();
  const std::vector<Colour> colours = {{255, 0, 0, 51}, {0, 0, 255, 255}};  // a fifth of red over blue
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 4, 4);
  for (const PaintersOrder& order : {depth_sort(mesh, scene.view).order, BspTree(mesh).order(scene.view)}) {
    CHECK(paint(mesh, scene.view, order, grid, colours, 1).at(1, 1) == Colour{51, 0, 204, 255});
    // Half of each: blue over white, then a tenth of red.
    CHECK(paint(mesh, scene.view, order, grid, colours, 0.5).at(2, 2) == Colour{140, 115, 230, 255});
  }
}

}  // namespace
}  // namespace hsr
