// What a caller may rely on beside results: meshes from arrays, cancelling, threads.
#include <tbb/global_control.h>

#include <array>
#include <catch2/catch.hpp>
#include <stop_token>

#include "hsr/hsr.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
const std::array<Point3, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
const std::array<Triangle, 4> tetrahedron = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

TEST_CASE("a mesh of flat arrays is the mesh of the polygons", "[calls][mesh]") {
  const std::vector<std::uint32_t> flat = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, first = {0, 3, 6, 9, 12};
  Polygons polygons;
  polygons.corners = flat;
  polygons.first = first;
  const Mesh expected = make_mesh({corners.begin(), corners.end()}, polygons);
  for (const Mesh& mesh : {make_mesh(corners, flat, first), make_mesh(corners, tetrahedron)}) {
    CHECK(mesh.points == expected.points);
    CHECK(mesh.triangles == expected.triangles);
    CHECK(mesh.edges.size() == expected.edges.size());
    CHECK(mesh.sides == expected.sides);
  }
  CHECK(make_mesh(corners, flat, std::array<std::uint32_t, 3>{0, 3, 12}).faces.size() == 2);
  CHECK_THROWS_AS(make_mesh(corners, flat, std::array<std::uint32_t, 2>{0, 13}), PreconditionError);
  CHECK_THROWS_AS(make_mesh(corners, flat, std::vector<std::uint32_t>{}), PreconditionError);
  CHECK_THROWS_AS(make_mesh(corners, std::array<Triangle, 1>{{{0, 1, 4}}}), InputError);
}

TEST_CASE("work that is asked to stop ends in a CancelledError, and the scene may be asked again", "[calls][cancel]") {
  for (const bool is_convex : {true, false}) {
    const scenes::TestScene test = scenes::family("triangles").make(3);
    const Mesh mesh = is_convex ? make_mesh(corners, tetrahedron) : test.mesh();
    const SceneView scene(mesh, test.view);
    std::stop_source source;
    source.request_stop();
    const std::stop_token stop = source.get_token();
    for (const LineMethod method : {LineMethod::automatic, LineMethod::appel, LineMethod::roberts}) {
      LineOptions options;
      options.method = method;
      options.stop = stop;
      CHECK_THROWS_AS(visible_lines(scene, options), CancelledError);
    }
    CHECK_THROWS_AS(visible_fragments(scene, {.stop = stop}), CancelledError);
    CHECK_THROWS_AS(depth_sort(scene, {.stop = stop}), CancelledError);
    CHECK(!visible_lines(scene).lines.empty());
    CHECK(!visible_fragments(scene).fragments.empty());
    CHECK(!depth_sort(scene).order.pieces.empty());
  }
}

TEST_CASE("work may be stopped while it runs", "[calls][cancel]") {
  // Many small faces, so that there are many blocks of work.
  std::vector<Point3> points;
  std::vector<Triangle> faces;
  for (std::uint32_t k = 0; k < 20000; ++k) {
    const double x = k % 200, y = static_cast<double>(k) / 200;
    points.insert(points.end(), {{x, y, 0.1 * (k % 7)}, {x + 1.5, y, 0.2 * (k % 5)}, {x, y + 1.5, 0.3 * (k % 3)}});
    faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Mesh mesh = make_mesh(points, faces);
  const SceneView scene(mesh, parallel_view({0, 0, 1}, {0, 1, 0}));
  std::stop_source source;
  int calls = 0;
  LineOptions options;
  options.method = LineMethod::roberts;
  options.stop = source.get_token();
  options.progress = [&](double) {
    ++calls;
    source.request_stop();
  };
  CHECK_THROWS_AS(visible_lines(scene, options), CancelledError);
  CHECK(calls >= 1);
  CHECK(calls < 10);  // of a hundred

  // What the progress function throws arrives as it is.
  struct Enough {};
  LineOptions throwing;
  throwing.progress = [](double) { throw Enough(); };
  CHECK_THROWS_AS(visible_lines(scene, throwing), Enough);
  CHECK_THROWS_AS(visible_fragments(scene, {.progress = throwing.progress}), Enough);
}

TEST_CASE("of several limits of threads the smallest holds while it lives", "[calls][threads]") {
  const auto now = [] { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism); };
  const std::size_t before = now();
  {
    const Threads three(3);
    CHECK(now() == 3);
    {
      const Threads one(1);
      CHECK(now() == 1);
      const Threads two(2);
      CHECK(now() == 1);
    }
    CHECK(now() == 3);
  }
  CHECK(now() == before);
  CHECK_THROWS_AS(Threads(0), PreconditionError);
}

}  // namespace
}  // namespace hsr
