// One scene in tiles of the image, and on one machine: the same lines, item by item, and the same drawings.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>

#include "geometry/merge_points.h"
#include "hsr/drawing/drawing.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/write.h"
#include "hsr/model.h"
#include "hsr/tiles/drawing_numbers.h"
#include "hsr/tiles/tile_lines.h"
#include "hsr/tiles/united_lines.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

using namespace internal;

Model model_of(const scenes::TestScene& scene) {
  Model model;
  model.points = scene.points;
  for (Point3& p : model.points) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  model.polygons = scene.polygons;
  return model;
}

std::vector<Point3> corners_of(const Model& model, std::span<const std::uint32_t> corners) {
  std::vector<Point3> points;
  for (const std::uint32_t c : corners) points.push_back(model.points[c]);
  return points;
}

/// What each tile takes.
std::vector<ModelPart> parts_of(const Model& model, const View& view, const ImageTiles& tiles) {
  const auto merged = merge_points({model.points.begin(), model.points.end()});
  std::vector<std::uint32_t> stands_for;
  for (const VertexId v : merged) stands_for.push_back(v.value);
  TileFinder finder(tiles, view, bit_range(model.points));
  std::vector<std::vector<std::uint32_t>> faces(tiles.count()), segments(tiles.count());
  std::vector<std::uint32_t> found;
  for (std::uint32_t f = 0; f < model.polygons.size(); ++f) {
    found.clear();
    finder.find(corners_of(model, model.polygons[f]), found);
    for (const std::uint32_t t : found) faces[t].push_back(f);
  }
  for (std::uint32_t s = 0; s < model.polygons.segments.size(); ++s) {
    found.clear();
    finder.find(corners_of(model, model.polygons.segments[s]), found);
    for (const std::uint32_t t : found) segments[t].push_back(s);
  }
  std::vector<ModelPart> parts;
  for (std::uint32_t t = 0; t < tiles.count(); ++t) parts.push_back(part_of(model, stands_for, {faces[t], segments[t]}));
  return parts;
}

ImageTiles tiles_for(const Model& model, const View& view, std::uint32_t count) {
  std::vector<Point2> places;
  for (const Point3& p : model.points) places.push_back(place_in_frame(view, p));
  return balanced_tiles(view, places, count);
}

struct Drawn {
  std::string json, svg;
};

Drawn in_one_piece(const Model& model, const View& view, TileRequest request) {
  const Mesh mesh = make_mesh(model.points, model.polygons);
  request.scene.hidden_lines = !request.only_visible;
  const SceneView scene(Scene::of(mesh, labels_of(model)), view, request.scene);
  const VisibleLines lines = visible_lines(scene, request.lines);
  DrawingOptions options;
  options.hidden = request.only_visible ? HiddenLines::none : HiddenLines::dashed;
  options.leave_out_near = true;
  return {request.only_visible ? std::string() : lines_json(mesh, view, lines, {Numbers::exact}),
          written(draw(mesh, view, lines, options), "svg", {})};
}

Drawn in_tiles(const Model& model, const View& view, const ImageTiles& tiles, const TileRequest& request) {
  std::vector<ModelPart> parts = parts_of(model, view, tiles);
  std::vector<TilePart> found;
  for (std::uint32_t t = 0; t < tiles.count(); ++t) found.push_back(lines_of_tile(parts[t], view, tiles, t, request));
  std::reverse(found.begin(), found.end());
  const UnitedTiles all = united_tiles(std::move(found), view, tiles, request.only_visible);
  JsonOptions json{Numbers::exact};
  json.point_numbers = all.part.points;
  json.face_numbers = all.part.faces;
  DrawingOptions options;
  options.hidden = request.only_visible ? HiddenLines::none : HiddenLines::dashed;
  options.leave_out_near = true;
  Drawing drawing = draw(all.mesh, view, all.lines, options);
  give_numbers(drawing, all.part);
  return {request.only_visible ? std::string() : lines_json(all.mesh, view, all.lines, json), written(drawing, "svg", {})};
}

double more_scenes() {
  const char* text = std::getenv("HSR_TEST_SCENES");
  return text == nullptr ? 1 : std::strtod(text, nullptr);
}

/// The first line of two texts in which they differ.
std::string difference(const std::string& one, const std::string& other) {
  std::istringstream x(one), y(other);
  std::string in_one, in_other;
  do {
    if (!std::getline(x, in_one)) in_one = "nothing";
    if (!std::getline(y, in_other)) in_other = "nothing";
  } while (in_one == in_other && in_one != "nothing");
  return "one piece:\n" + in_one + "\ntiles:\n" + in_other + "\n";
}

int compared = 0;  // scenes that were not refused

/// "", or how the two differ.
std::string wrong_with(const Model& model, const View& view, const std::function<ImageTiles()>& tiles,
                       const TileRequest& request) {
  try {
    const Drawn whole = in_one_piece(model, view, request);
    const Drawn united = in_tiles(model, view, tiles(), request);
    ++compared;
    if (whole.json != united.json) return difference(whole.json, united.json);
    if (whole.svg != united.svg) return difference(whole.svg, united.svg);
  } catch (const InputError& e) {
    const std::string text = e.what();
    if (text.find("as many faces coincide") != std::string::npos) return {};
    if (text.starts_with("scale: ") || text.starts_with("tiles: the picture")) return {};
    return text;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what();
  }
  return {};
}

std::string wrong_with(const scenes::TestScene& scene, std::uint32_t count, const TileRequest& request) {
  const Model model = model_of(scene);
  return wrong_with(
      model, scene.view, [&] { return tiles_for(model, scene.view, count); }, request);
}

/// Columns that end at these places of the frame, each in rows that end at others, moved by `shift` from column to column.
ImageTiles grid(const View& view, const std::vector<double>& columns, const std::vector<double>& rows, double shift) {
  ImageTiles tiles;
  std::int32_t next = 0;
  const auto add_split = [&](int axis, double at) {
    tiles.sides.push_back(tile_side(view, axis, at, 16));
    tiles.splits.emplace_back();
    return tiles.splits.size() - 1;
  };
  const std::function<std::int32_t(std::size_t, double)> row = [&](std::size_t k, double moved) {
    if (k == rows.size()) return ~(next++);
    const std::size_t split = add_split(1, rows[k] + moved);
    const std::int32_t here = ~(next++), others = row(k + 1, moved);
    tiles.splits[split] = {here, others};
    return static_cast<std::int32_t>(split);
  };
  const std::function<std::int32_t(std::size_t)> column = [&](std::size_t k) {
    const double moved = shift * static_cast<double>(k);
    if (k == columns.size()) return row(0, moved);
    const std::size_t split = add_split(0, columns[k]);
    const std::int32_t here = row(0, moved), others = column(k + 1);
    tiles.splits[split] = {others, here};  // left of a side that runs upward is positive
    return static_cast<std::int32_t>(split);
  };
  column(0);
  return tiles;
}

void agrees_on(const std::string& name, std::uint64_t first_seed, int count, bool only_visible) {
  const scenes::Family& family = scenes::family(name);
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 3; ++seed) {
    TileRequest request;
    request.only_visible = only_visible;
    if (!only_visible || seed % 2 == 0) request.lines.classes.fill(true);
    if (seed % 3 == 1) request.lines.method = LineMethod::roberts;
    if (seed % 3 == 2) request.lines.method = LineMethod::appel;
    scenes::TestScene scene = family.make(seed);
    const auto tiles = static_cast<std::uint32_t>(1 + seed % 7);
    if (wrong_with(scene, tiles, request).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong_with(s, tiles, request).empty(); });
    FAIL_CHECK(name << " " << seed << ", " << tiles << " tiles:\n"
                    << scenes::to_text(scene) << wrong_with(scene, tiles, request));
  }
  CHECK(failures == 0);
}

TEST_CASE("tiles give the lines of one piece, hidden ones and classes and intersections too", "[tiles][property]") {
  for (const scenes::Family& family : scenes::families()) {
    INFO(family.name);
    agrees_on(family.name, 0, 150, false);
  }
}

TEST_CASE("tiles with only what is visible give the drawing of one piece", "[tiles][property]") {
  for (const scenes::Family& family : scenes::families()) {
    INFO(family.name);
    agrees_on(family.name, 1000, 150, true);
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

TEST_CASE("most scenes of the tests are not refused", "[tiles]") { CHECK(compared > 3000); }

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
