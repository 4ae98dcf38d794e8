// One scene in tiles of the image, and on one machine: the same lines, item by item, and the same drawings.
#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "hsr/tiles/united_lines.h"
#include "tests/scenes/random_scenes.h"
#include "tests/tiles/checked_tiles.h"

namespace hsr {
namespace {

using namespace internal;
using namespace tiles_tests;

TEST_CASE("tiles give the lines of one piece, hidden ones and classes and intersections too", "[tiles][property]") {
  for (const scenes::Family& family : scenes::families()) {
    INFO(family.name);
    agree_on(family.name, 0, 150, {.only_visible = false});
  }
}

TEST_CASE("tiles with only what is visible give the drawing of one piece", "[tiles][property]") {
  for (const scenes::Family& family : scenes::families()) {
    INFO(family.name);
    agree_on(family.name, 1000, 150, {.only_visible = true});
  }
}

TEST_CASE("sides through corners, along edges and in faces seen edge-on change nothing", "[tiles][property]") {
  const std::vector<std::vector<double>> columns = {{}, {0}, {-2, 1}, {-3, -1, 0, 2}}, rows = {{}, {1}, {-1, 0, 2}};
  for (const char* name : {"triangles", "polygons", "boxes", "edge_on"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Model model = model_of(scenes::family(name).make(seed));
      // The frame is along the axes, so that sides at whole numbers go through corners.
      const View view =
          seed % 4 == 3 ? perspective_view({0, 0, 8}, {0, 0, 0}, {0, 1, 0}, 0.5) : parallel_view({0, 0, 1}, {0, 1, 0});
      TileRequest request;
      request.lines.classes.fill(true);
      request.only_visible = seed % 2 == 0;
      const auto &x = columns[seed % 4], &y = rows[seed % 3];
      INFO(name << " " << seed);
      CHECK(wrong_with(
                model, view, [&] { return grid(view, x, y, seed % 5 == 0 ? 1 : 0); }, request) == "");
    }
}

TEST_CASE("ghosts, objects, materials and wires are in tiles what they are in one piece", "[tiles]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::TestScene scene = scenes::family(seed % 2 == 0 ? "triangles" : "polygons").make(seed);
    Model model = model_of(scene);
    const std::size_t faces = model.polygons.size();
    model.objects = {"a", "b", "c"};
    model.materials = {"wood", "stone"};
    for (std::size_t f = 0; f < faces; ++f) {
      model.face_object.push_back(f % 5 == 0 ? 0xffffffffU : static_cast<std::uint32_t>(f % 3));
      model.face_material.push_back(static_cast<std::uint32_t>(f % 2));
      model.polygons.is_ghost.push_back(f % 4 == 3 ? 1 : 0);
    }
    for (std::size_t s = 0; s < model.polygons.segments.size(); ++s)
      model.segment_object.push_back(static_cast<std::uint32_t>(s % 3));
    TileRequest request;
    request.lines.classes.fill(true);
    request.scene.coplanar = seed % 3 == 0 ? Coplanar::last : Coplanar::first;
    request.only_visible = seed % 5 == 0;
    INFO(seed);
    CHECK(wrong_with(
              model, scene.view, [&] { return tiles_for(model, scene.view, 2 + seed % 5); }, request) == "");
  }
}

TEST_CASE("a drawing in tiles is placed by what is seen", "[tiles]") {
  // The first edge is hidden. Of what class, and so whether it is listed, is told by a closed box, of which a tile has some faces; the
  // centre of the page is rounded from a vertex.
  scenes::TestScene scene;
  scene.add_box({1, 0, 3}, {2, 3, 4});
  const std::array<Point3, 8> p = {Point3{1, 0, 0}, {4, 0, 0}, {1, 2, 0}, {4, 2, 0},
                                   {1, 0, 3},       {4, 0, 3}, {1, 2, 3}, {4, 2, 3}};
  for (const auto& [a, b, c] : {std::array{0, 2, 3}, {4, 5, 7}, {0, 5, 4}, {2, 6, 7}, {0, 4, 6}})
    scene.add_face({p[static_cast<std::size_t>(a)], p[static_cast<std::size_t>(b)], p[static_cast<std::size_t>(c)]});
  const View view = perspective_view({-3, 1, 8}, {2.25, 2.25, 2.25}, {0, 0, 1}, 0.01);
  const Model model = model_of(scene);
  TileRequest request;
  request.only_visible = true;
  for (std::uint32_t tiles = 2; tiles < 8; ++tiles)
    CHECK(wrong_with(
              model, view, [&] { return tiles_for(model, view, tiles); }, request) == "");
}

TEST_CASE("most scenes of the tests are not refused", "[tiles]") { CHECK(compared_scenes() > 3000); }

TEST_CASE("tiles that do not fit together are found out", "[tiles]") {
  scenes::TestScene scene;
  scene.add_box({0, 0, 0}, {8, 8, 1});
  scene.add_box({2, 2, 1}, {6, 6, 3});
  scene.view = scenes::from_direction({1, 2, 3});
  const Model model = model_of(scene);
  const ImageTiles tiles = tiles_for(model, scene.view, 4);
  for (const bool only_visible : {false, true}) {
    TileRequest request;
    request.only_visible = only_visible;
    const std::vector<ModelPart> parts = parts_of(model, scene.view, tiles);
    std::vector<TilePart> all;
    for (std::uint32_t t = 0; t < 4; ++t) all.push_back(lines_of_tile(parts[t], scene.view, tiles, t, request));
    CHECK_NOTHROW(united_tiles(all, scene.view, tiles, only_visible));
    for (std::size_t missing = 0; missing < 4; ++missing) {
      std::vector<TilePart> some = all;
      some.erase(some.begin() + static_cast<std::ptrdiff_t>(missing));
      CHECK_THROWS_AS(united_tiles(some, scene.view, tiles, only_visible), TileMismatch);
    }
    // One that is of the scene as it was before.
    Model before = model;
    for (std::size_t p = 8; p < 16; ++p) before.points[p].x += 1;
    const std::vector<ModelPart> old_parts = parts_of(before, scene.view, tiles);
    std::vector<TilePart> mixed = all;
    mixed[1] = lines_of_tile(old_parts[1], scene.view, tiles, 1, request);
    CHECK_THROWS(united_tiles(mixed, scene.view, tiles, only_visible));
  }
}

TEST_CASE("what tiles cannot tell is refused", "[tiles]") {
  const auto refuses = [](const View& view, const TileRequest& request, const char* option) {
    try {
      check_tile_request(view, request);
    } catch (const InputError& e) {
      return std::string(e.what()).starts_with(option);
    }
    return false;
  };
  const View view = parallel_view({0, 0, 1}, {0, 1, 0});
  TileRequest request;
  CHECK_NOTHROW(check_tile_request(view, request));
  CHECK(refuses(with_section(view, {0, 0, 0}, {0, 0, 1}), request, "section:"));
  request.lines.tolerance = 0.1;
  CHECK(refuses(view, request, "tolerance:"));
  request.lines.tolerance = 0;
  request.lines.crease_goes_on = 20;
  CHECK(refuses(view, request, "crease:"));
}

}  // namespace
}  // namespace hsr
