#include "hsr/raster/caster.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <string>

#include "geometry/error.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/raster/aligned_grids.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

double more_scenes() {
  const char* text = std::getenv("HSR_TEST_SCENES");
  return text == nullptr ? 1 : std::strtod(text, nullptr);
}

std::string text_of(const Image<TriangleId>& image) {
  std::string text;
  for (int j = 0; j < image.height; ++j) {
    for (int i = 0; i < image.width; ++i) {
      const TriangleId t = image.at(i, j);
      text += t.is_valid() ? static_cast<char>(t.value < 10 ? '0' + t.value : 'a' + (t.value - 10) % 26) : '.';
    }
    text += '\n';
  }
  return text;
}

/// Empty, or what the caster and the oracle say.
std::string wrong_with(const scenes::TestScene& scene) {
  const Mesh mesh = scene.mesh();
  for (const SampleGrid& grid : aligned_grids(mesh, scene.view)) {
    const Image<TriangleId> expected = oracle::seen_at_samples(mesh, scene.view, grid);
    for (const Arithmetic arithmetic : {Arithmetic::staged, Arithmetic::interval, Arithmetic::rational}) {
      try {
        const Image<TriangleId> found = cast(SceneView(mesh, scene.view, {.arithmetic = arithmetic}), grid).triangles;
        if (found != expected) return "cast:\n" + text_of(found) + "expected:\n" + text_of(expected);
      } catch (const PreconditionError& error) {
        if (std::string(error.what()) != "SampleSigns: the viewpoint is in the plane of the samples") throw;
      }
    }
  }
  return {};
}

void agrees_on(const scenes::Family& family, std::uint64_t first_seed, int count) {
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 3; ++seed) {
    scenes::TestScene scene = family.make(seed);
    scene.name = std::string(family.name) + " " + std::to_string(seed);
    if (wrong_with(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong_with(s).empty(); });
    FAIL_CHECK(scenes::to_text(scene) << wrong_with(scene));
  }
  CHECK(failures == 0);
}

// Seen from above, x to the right, y up; row 0 at y = 3.
const View from_above = parallel_view({0, 0, 1}, {0, 1, 0});
const SampleGrid four_by_four = {{0, 3, 0}, {1, 0, 0}, {0, -1, 0}, 4, 4};

std::string cast_text(const scenes::TestScene& scene, const SampleGrid& grid = four_by_four) {
  const Mesh mesh = scene.mesh();
  const Image<TriangleId> found = cast(mesh, scene.view, grid).triangles;
  CHECK(text_of(found) == text_of(oracle::seen_at_samples(mesh, scene.view, grid)));
  return text_of(found);
}

TEST_CASE("a square has the samples on its left and upper edges, and not those on the right and lower", "[image][caster][G3]") {
  scenes::TestScene scene;
  scene.view = from_above;
  scene.add_face(std::vector<Point3>{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}});
  scene.add_face(std::vector<Point3>{{1, 1, 0}, {3, 3, 0}, {1, 3, 0}});
  // The diagonal runs up to the right: a sample on it is moved to the right, below it, into 0.
  CHECK(cast_text(scene) ==
        ".11.\n"
        ".10.\n"
        "....\n"
        "....\n");
}

TEST_CASE("of faces in one plane the lowest index is seen, else the nearest", "[image][caster][G5]") {
  scenes::TestScene scene;
  scene.view = from_above;
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {0, 8, 0}, {8, 0, 0}});
  CHECK(cast_text(scene) == "0000\n0000\n0000\n....\n");
  scene.add_face(std::vector<Point3>{{2, 0, 1}, {8, 0, 1}, {2, 8, 1}});
  CHECK(cast_text(scene) == "0022\n0022\n0022\n....\n");
}

TEST_CASE("where faces cross exactly at samples, what is nearer on the right is seen", "[image][caster][G5]") {
  scenes::TestScene scene;
  scene.view = from_above;
  // 0 is flat; 1 rises to the right and passes through it at x = 2.
  scene.add_face(std::vector<Point3>{{-8, -8, 0}, {16, -8, 0}, {-8, 16, 0}});
  scene.add_face(std::vector<Point3>{{-8, -8, -10}, {16, -8, 14}, {-8, 16, -10}});
  CHECK(cast_text(scene) == "0011\n0011\n0011\n0011\n");
}

TEST_CASE("faces seen edge-on are not seen, nor what is before the near plane", "[image][caster][G6]") {
  scenes::TestScene scene;
  scene.view = from_above;
  scene.add_face(std::vector<Point3>{{0, 1, 0}, {3, 1, 0}, {0, 1, 5}});
  CHECK(cast_text(scene) == "....\n....\n....\n....\n");

  scenes::TestScene from_eye;
  from_eye.view = scenes::from_eye({2, 2, 4}, {2, 2, 0}, 0.5);
  // Rises to the right, into the near plane z = 2 over x = 2, which is in the middle of the picture.
  from_eye.add_face(std::vector<Point3>{{-8, -8, -8}, {16, -8, 16}, {-8, 16, -8}});
  CHECK(cast_text(from_eye) == "00..\n00..\n00..\n00..\n");
}

TEST_CASE("a mesh seen from within is cast on all sides of the near plane", "[image][caster]") {
  scenes::TestScene scene;
  scene.view = scenes::from_eye({0, 0, 0}, {0, 0, -4}, 0.25);
  // A floor from behind the eye to far ahead.
  scene.add_face(std::vector<Point3>{{-100, -1, 100}, {100, -1, 100}, {100, -1, -100}, {-100, -1, -100}});
  const std::string seen = cast_text(scene, {{-6, 6, -4}, {4, 0, 0}, {0, -4, 0}, 4, 4});
  CHECK(seen == "....\n....\n1110\n....\n");
}

TEST_CASE("the caster agrees with the oracle on random scenes, samples on vertices and edges", "[image][caster][oracle]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 0, 20); }
  }
}

TEST_CASE("the caster agrees with the oracle on many more random scenes", "[image][caster][oracle][long]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 1'000'000, 1000); }
  }
}

TEST_CASE("what is behind a covered tile is passed over, and nothing else is", "[image][caster][oracle]") {
  std::mt19937_64 random(11);
  const auto between = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1)));
  };
  // The plane of the samples passes through the faces, is before them all, and behind.
  for (const View& view : {from_above, parallel_view({1, -2, 7}, {0, 1, 0}, {0, 0, 30}),
                           parallel_view({0, 0, 2}, {0, 1, 0}, {0, 0, -30}), scenes::from_eye({0, 0, 40}, {0, 0, 0}),
                           scenes::from_eye({0, 0, 60}, {0, 0, 30}), scenes::from_eye({10, 5, 20}, {0, 0, 0}, 0.25)}) {
    scenes::TestScene scene;
    scene.view = view;
    // Large and small faces on many levels, steep and flat: several cover a tile, and many pass through it.
    for (int k = 0; k < 120; ++k) {
      const double x = between(-20, 20), y = between(-20, 20), z = between(-12, 12), size = between(2, k % 4 == 0 ? 60 : 12);
      const auto corner = [&](double dx, double dy) {
        const double rise = between(-6, 6);
        return Point3{x + dx * size, y + dy * size, z + rise};
      };
      const Point3 a = corner(-1, -1), b = corner(1, -1), c = corner(0, 1);
      scene.add_face(std::vector<Point3>{a, b, c});
    }
    const Mesh mesh = scene.mesh();
    const SampleGrid grid = sample_grid(view, PaperRectangle{-12, 12, -8, 8}, 36, 24);
    CHECK(cast(mesh, view, grid).triangles == oracle::seen_at_samples(mesh, view, grid));
  }
}

TEST_CASE("of no triangles nothing is seen, and one sample is a picture", "[image][caster]") {
  scenes::TestScene scene;
  scene.view = from_above;
  CHECK(cast_text(scene) == "....\n....\n....\n....\n");
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
  CHECK(cast_text(scene, {{1, 1, 0}, {1, 0, 0}, {0, -1, 0}, 1, 1}) == "0\n");
  CHECK(cast_text(scene, {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 1, 1}) == ".\n");  // moved down, out of it
  CHECK_THROWS_AS(cast(scene.mesh(), scene.view, {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 4, 4}), PreconditionError);
  CHECK_THROWS_AS(cast(scene.mesh(), scene.view, {{0, 0, 0}, {1, 0, 0}, {0, 0x1p-60, 0}, 4, 4}), PreconditionError);
}

TEST_CASE("plain doubles may be wrong, but give a picture", "[image][caster]") {
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      try {
        const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 16, 12);
        const CastImage image = cast(SceneView(mesh, scene.view, {.arithmetic = Arithmetic::double_only}), grid);
        CHECK(image.triangles.width == 16);
      } catch (const InputError&) {
        // Beyond the range of doubles.
      } catch (const PreconditionError&) {
        // For plain doubles the viewpoint is in the plane of the samples.
      }
    }
}

TEST_CASE("the cast picture and its counts do not depend on the number of threads", "[image][caster]") {
  const scenes::TestScene scene = scenes::family("echoes").make(3);
  const Mesh mesh = scene.mesh();
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 200, 150);
  const CastImage many = cast(mesh, scene.view, grid);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const CastImage single = cast(mesh, scene.view, grid);
  CHECK(many.triangles == single.triangles);
  CHECK(many.decisions == single.decisions);
}

}  // namespace
}  // namespace hsr
