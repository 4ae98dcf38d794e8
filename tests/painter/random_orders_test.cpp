#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <exception>
#include <random>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/caster.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/scenes/corpus.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// Samples at which the painting shows another face than the nearest.
std::string wrong_samples(const Mesh& mesh, const View& view, const PaintersOrder& order) {
  try {
    const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 24, 24);
    const OrderCheck check = check_order(mesh, view, order, grid);
    return check.wrong == 0 ? "" : std::to_string(check.wrong) + " samples show another face\n";
  } catch (const PreconditionError&) {
    return "";  // the eye in the plane of the samples, or samples that are no doubles
  } catch (const InputError&) {
    return "";  // a picture beyond all doubles
  }
}

std::string wrong_order(const scenes::TestScene& scene) {
  try {
    const Mesh mesh = scene.mesh();
    std::string wrong;
    const auto check = [&](const char* method, const PaintersOrder& order) {
      for (const std::string& w : oracle::wrong_with_order(mesh, scene.view, order))
        wrong.append(method).append(": ").append(w).append("\n");
      wrong += wrong_samples(mesh, scene.view, order);
    };
    check("depth sort", depth_sort(mesh, scene.view).order);
    DepthSortOptions classic;
    classic.classic = true;
    check("classic depth sort", depth_sort(mesh, scene.view, classic).order);
    check("bsp", BspTree(mesh).order(scene.view));
    return wrong;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

/// Samples at which transparent faces, painted in this order, have another colour than all layers along the line of sight.
std::string wrong_colours(const scenes::TestScene& scene, const PaintersOrder& order) {
  const Mesh mesh = scene.mesh();
  std::mt19937_64 random(5);
  std::vector<Colour> colours(mesh.faces.size());
  for (Colour& c : colours)
    for (std::uint8_t& x : c) x = static_cast<std::uint8_t>(20 + random() % 230);
  Image<std::vector<TriangleId>> layers;
  Image<Colour> found;
  SampleGrid grid;
  try {
    grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 12, 12);
    found = paint(mesh, scene.view, order, grid, colours, 0.9);
  } catch (const std::exception&) {
    return "";  // no samples, as above
  }
  layers = oracle::layers_at_samples(mesh, scene.view, grid);
  for (std::size_t k = 0; k < layers.pixels.size(); ++k) {
    std::array<float, 3> light = {255, 255, 255};
    for (std::size_t layer = layers.pixels[k].size(); layer-- > 0;) {
      const Colour& c = colours[mesh.face_of[layers.pixels[k][layer]].value];
      const float a = static_cast<float>(0.9 * c[3] / 255);
      for (std::size_t x = 0; x < 3; ++x) light[x] += a * (static_cast<float>(c[x]) - light[x]);
    }
    for (std::size_t x = 0; x < 3; ++x)
      if (found.pixels[k][x] != static_cast<std::uint8_t>(std::lround(light[x])))
        return "sample " + std::to_string(k) + " has another colour\n";
  }
  return "";
}

TEST_CASE("transparent faces have the colours of all layers along each line of sight", "[painter][oracle][P3]") {
  int naive = 0;  // scenes where the order of most software has other colours, or the test would say nothing
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Mesh mesh = scene.mesh();
      INFO(family.name << " " << seed);
      CHECK(wrong_colours(scene, depth_sort(mesh, scene.view).order) == "");
      CHECK(wrong_colours(scene, BspTree(mesh).order(scene.view)) == "");
      if (!wrong_colours(scene, z_sort(mesh, scene.view, DepthKey::centroid)).empty()) ++naive;
    }
  CHECK(naive > 20);
}

void agrees_on(const scenes::Family& family, std::uint64_t first, int count) {
  int failures = 0;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count) && failures < 3; ++seed) {
    scenes::TestScene scene = family.make(seed);
    scene.name = std::string(family.name) + " " + std::to_string(seed);
    if (wrong_order(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [](const scenes::TestScene& s) { return !wrong_order(s).empty(); });
    FAIL_CHECK("For tests/corpus:\n" << scenes::to_text(scene) << wrong_order(scene));
  }
  CHECK(failures == 0);
}

TEST_CASE("every pair of pieces is in order, by each method, on every family of scenes", "[painter][oracle][P1][P4]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 0, 60); }
  }
}

TEST_CASE("a face that crosses itself often covers each place once, whichever of its triangles is on top",
          "[painter][oracle][P14]") {
  std::mt19937_64 random(14);
  for (int round = 0; round < 40; ++round) {
    std::vector<Point3> points;
    std::vector<std::uint32_t> corners;
    const int n = 5 + round % 9;
    for (int k = 0; k < n; ++k) {
      const auto x = static_cast<double>(random() % 17), y = static_cast<double>(random() % 17);
      points.push_back({x, y, x - y});
      corners.push_back(static_cast<std::uint32_t>(k));
    }
    for (const Point3 p : {Point3{2, 2, -9}, Point3{15, 3, 15}, Point3{9, 16, 3}}) {  // and a face through it
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    const std::vector<std::uint32_t> first = {0, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n + 3)};
    const Mesh mesh = make_mesh(points, corners, first);
    const View view = round % 2 == 0 ? parallel_view({1, 2, 9}, {0, 1, 0}) : perspective_view({5, 7, 60}, {8, 8, 0}, {0, 1, 0});
    INFO("round " << round);
    for (const Coplanar coplanar : {Coplanar::first, Coplanar::last}) {
      const SceneView scene(mesh, view, {.coplanar = coplanar});
      CHECK(oracle::wrong_with_order(mesh, view, depth_sort(scene).order, coplanar) == std::vector<std::string>{});
      CHECK(oracle::wrong_with_order(mesh, view, BspTree(mesh).order(scene), coplanar) == std::vector<std::string>{});
    }
  }
}

TEST_CASE("every pair of pieces is in order on every scene of the corpus", "[painter][oracle][corpus]") {
  for (const auto& file : scenes::corpus(HSR_CORPUS)) {
    DYNAMIC_SECTION(file.filename().string()) { CHECK(wrong_order(scenes::scene_from_file(file)) == ""); }
  }
}

TEST_CASE("every pair of pieces is in order at every size", "[painter][oracle][stiff][E1]") {
  for (const double by : {0x1p900, 0x1p-900, 1e150, 1e-150, 1e300, 1e-300})
    for (const char* family : {"triangles", "polygons", "slopes", "around_the_eye"})
      for (std::uint64_t seed = 800'000; seed < 800'004; ++seed) {
        scenes::TestScene scene = scenes::family(family).make(seed);
        const auto scaled = [&](const Point3& p) { return Point3{p.x * by, p.y * by, p.z * by}; };
        for (Point3& p : scene.points) p = scaled(p);
        const View& view = scene.view;
        scene.view = view.viewpoint.is_direction ? scenes::from_direction(view.viewpoint.at)
                                                 : scenes::from_eye(scaled(view.viewpoint.at), scaled(view.target), view.near);
        INFO(by << " " << family << " " << seed);
        CHECK(wrong_order(scene) == "");
      }
}

TEST_CASE("stacks and slopes that nearly coincide are in order", "[painter][oracle][stiff]") {
  std::mt19937_64 random(3);
  for (const double gap : {1e-12, 1e-300, 5e-324, 0x1p-52}) {
    // Fifty squares, shuffled; by ulps of 1 they start there.
    scenes::TestScene stack;
    stack.view = scenes::from_direction({0, 0, 1});
    std::vector<int> layers(50);
    for (int k = 0; k < 50; ++k) layers[static_cast<std::size_t>(k)] = k;
    std::shuffle(layers.begin(), layers.end(), random);
    for (const int k : layers) {
      const double z = (gap == 0x1p-52 ? 1 : 0) + gap * k;
      stack.add_face({Point3{0, 0, z}, Point3{1, 0, z}, Point3{1, 1, z}, Point3{0, 1, z}});
    }
    const Mesh mesh = stack.mesh();
    const PaintersOrder sorted = depth_sort(mesh, stack.view).order;
    REQUIRE(sorted.pieces.size() == 50);
    for (std::size_t k = 0; k < 50; ++k)
      CHECK(layers[mesh.face_of[first_triangle(sorted.pieces[k].facet)].value] == static_cast<int>(k));
    CHECK(wrong_order(stack) == "");
  }
  for (const double slope : {1e-3, 1e-9, 1e-15}) {
    scenes::TestScene crossing;
    crossing.view = scenes::from_direction({0, 0, 1});
    for (int k = 0; k < 12; ++k) {
      const double a = 6.28 * k / 12, c = std::cos(a), s = std::sin(a);
      crossing.add_face({Point3{c, s, slope * (k % 5 - 2)}, Point3{-s, c, slope * (k % 3 - 1)}, Point3{-c, -s, slope}});
    }
    CHECK(wrong_order(crossing) == "");
  }
}

TEST_CASE("every pair of pieces is in order on many more random scenes", "[painter][oracle][long]") {
  for (const scenes::Family& family : scenes::families()) {
    DYNAMIC_SECTION(family.name) { agrees_on(family, 1'000'000, 10'000); }
  }
}

}  // namespace
}  // namespace hsr
