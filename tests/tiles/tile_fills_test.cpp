// Fills in tiles of the image, and on one machine: the same fragments, point by point, and the same drawings.
#include <algorithm>
#include <catch2/catch.hpp>

#include "hsr/tiles/tile_bytes.h"
#include "hsr/tiles/united_lines.h"
#include "tests/scenes/random_scenes.h"
#include "tests/tiles/checked_tiles.h"

namespace hsr {
namespace {

using namespace internal;
using namespace tiles_tests;

TEST_CASE("tiles give the fragments and the fills of one piece", "[tiles][fills][property]") {
  for (const scenes::Family& family : scenes::families()) {
    INFO(family.name);
    agree_on(family.name, 2000, 90, {.only_visible = true, .fragments = true});
    agree_on(family.name, 3000, 60, {.only_visible = false, .fragments = true});
  }
}

TEST_CASE("sides through corners of fills and along their sides change nothing", "[tiles][fills][property]") {
  const std::vector<std::vector<double>> columns = {{}, {0}, {-2, 1}, {-3, -1, 0, 2}}, rows = {{}, {1}, {-1, 0, 2}};
  for (const char* name : {"triangles", "polygons", "boxes", "edge_on", "stacks"})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      Model model = model_of(scenes::family(name).make(seed));
      give_colours(model, 1 + static_cast<std::uint32_t>(seed % 3));
      // The frame is along the axes, so that sides at whole numbers go through corners.
      const View view =
          seed % 4 == 3 ? perspective_view({0, 0, 8}, {0, 0, 0}, {0, 1, 0}, 0.5) : parallel_view({0, 0, 1}, {0, 1, 0});
      TileRequest request;
      request.fragments = true;
      request.only_visible = seed % 2 == 0;
      const auto &x = columns[seed % 4], &y = rows[seed % 3];
      INFO(name << " " << seed);
      CHECK(wrong_with(
                model, view, [&] { return grid(view, x, y, seed % 5 == 0 ? 1 : 0); }, request, merge_of(seed / 2)) == "");
    }
}

TEST_CASE("ghosts and objects are filled in tiles as they are in one piece", "[tiles][fills]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const scenes::TestScene scene = scenes::family(seed % 2 == 0 ? "triangles" : "polygons").make(seed);
    Model model = model_of(scene);
    model.objects = {"a", "b", "c"};
    for (std::size_t f = 0; f < model.polygons.size(); ++f) {
      model.face_object.push_back(f % 5 == 0 ? 0xffffffffU : static_cast<std::uint32_t>(f % 3));
      model.polygons.is_ghost.push_back(f % 4 == 3 ? 1 : 0);
    }
    for (std::size_t s = 0; s < model.polygons.segments.size(); ++s)
      model.segment_object.push_back(static_cast<std::uint32_t>(s % 3));
    TileRequest request;
    request.fragments = true;
    request.scene.coplanar = seed % 3 == 0 ? Coplanar::last : Coplanar::first;
    request.only_visible = seed % 2 == 0;
    INFO(seed);
    CHECK(wrong_with(
              model, scene.view, [&] { return tiles_for(model, scene.view, 2 + seed % 5); }, request, merge_of(seed)) == "");
  }
}

TEST_CASE("united regions come in one order, however exact the boxes are that tell which faces touch", "[tiles][fills]") {
  // Boxes are floats from the first point on. In one piece that is of a hidden face far away, and those of the first and the third
  // square, in one plane and almost touching, have a part in common; in tiles the hidden face is missing.
  scenes::TestScene scene;
  const auto add_square = [&](double x, double z) {
    scene.add_face({Point3{x, 0, z}, Point3{x + 1, 0, z}, Point3{x + 1, 1, z}, Point3{x, 1, z}});
  };
  add_square(1000.25, -1);
  add_square(0, 0);
  add_square(4, 1);
  add_square(1 + 0x1p-17, 0);
  scene.add_face({Point3{1000, -1, 0}, Point3{1002, -1, 0}, Point3{1002, 2, 0}, Point3{1000, 2, 0}});
  const View view = parallel_view({0, 0, 1}, {0, 1, 0});
  TileRequest request;
  request.lines.classes.fill(false);  // of a line of the hidden face tiles would have sent that, too
  request.fragments = request.only_visible = true;
  const Model model = model_of(scene);
  CHECK(wrong_with(
            model, view,
            [&] {
              return grid(view, {0.5, 500}, {}, 0);
            },
            request, Merge::coplanar) == "");
}

/// A plate with a box on it, in four tiles.
struct Plate {
  Plate() {
    scene.add_box({0, 0, 0}, {8, 8, 1});
    scene.add_box({2, 2, 1}, {6, 6, 3});
    scene.view = scenes::from_direction({1, 2, 3});
    model = model_of(scene);
    tiles = tiles_for(model, scene.view, 4);
    // Without lines fills alone tell what is missing.
    request.lines.classes.fill(false);
    request.only_visible = request.fragments = true;
    for (std::uint32_t t = 0; t < 4; ++t)
      parts.push_back(lines_of_tile(parts_of(model, scene.view, tiles)[t], scene.view, tiles, t, request));
  }
  scenes::TestScene scene;
  Model model;
  ImageTiles tiles;
  TileRequest request;
  std::vector<TilePart> parts;
};

TEST_CASE("a face that goes on where no tile has it names the tile", "[tiles][fills]") {
  const Plate plate;
  CHECK_NOTHROW(united_tiles(plate.parts, plate.scene.view, plate.tiles, true));
  for (std::uint32_t missing = 0; missing < 4; ++missing) {
    std::vector<TilePart> some = plate.parts;
    some.erase(some.begin() + missing);
    try {
      united_tiles(some, plate.scene.view, plate.tiles, true);
      FAIL_CHECK("a tile is missing, and nothing said so");
    } catch (const TileMismatch& e) {
      CHECK(e.tile != missing);
      CHECK(e.tile < 4);
      CHECK(e.thing == "face");
    }
  }
}

TEST_CASE("fragments of a tile have the same bytes after they were read", "[tiles][fills]") {
  const Plate plate;
  for (const TilePart& part : plate.parts) {
    CHECK(!part.fragments.empty());
    CHECK(tile_part_of(bytes_of(part)).fragments == part.fragments);
  }
  std::vector<TilePart> parts = plate.parts;
  parts[1].fragments.pop_back();
  CHECK_THROWS_AS(united_tiles(parts, plate.scene.view, plate.tiles, true), InputError);
}

}  // namespace
}  // namespace hsr
