#include "tests/tiles/checked_tiles.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <span>
#include <sstream>

#include "geometry/merge_points.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/write.h"
#include "hsr/tiles/drawing_numbers.h"
#include "hsr/tiles/united_lines.h"
#include "tests/scenes/random_scenes.h"

namespace hsr::tiles_tests {

using namespace internal;

namespace {

std::vector<Point3> corners_of(const Model& model, std::span<const std::uint32_t> corners) {
  std::vector<Point3> points;
  for (const std::uint32_t c : corners) points.push_back(model.points[c]);
  return points;
}

struct Drawn {
  std::string json, svg;
};

/// @param part empty: the scene is whole
Drawn drawn(const SceneView& scene, const Model& model, const VisibleLines& lines, const VisibleFragments& fragments,
            const TileRequest& request, Merge merge, const ModelPart* part) {
  const View& view = scene.view();
  JsonOptions json{Numbers::exact};
  if (request.fragments) json.fragments = &fragments;
  if (part != nullptr) {
    json.point_numbers = part->points;
    json.face_numbers = part->faces;
  }
  DrawingOptions options;
  options.hidden = request.only_visible ? HiddenLines::none : HiddenLines::dashed;
  options.leave_out_near = true;
  std::optional<Regions> fills;
  if (request.fragments) fills = regions_of(scene, fragments, face_colours(model, scene.mesh(), view), merge);
  Drawing drawing = draw(scene.mesh(), view, lines, options, fills ? &*fills : nullptr);
  if (part != nullptr) give_numbers(drawing, *part);
  Drawn result;
  result.svg = written(drawing, "svg", {});
  // Of lines without their hidden parts the pieces are not those of the whole.
  if (!request.only_visible || request.fragments)
    result.json = lines_json(scene.mesh(), view, request.only_visible ? VisibleLines() : lines, json);
  return result;
}

Drawn in_one_piece(const Model& model, const View& view, TileRequest request, Merge merge) {
  const Mesh mesh = make_mesh(model.points, model.polygons);
  request.scene.hidden_lines = !request.only_visible;
  const SceneView scene(Scene::of(mesh, labels_of(model)), view, request.scene);
  VisibleFragments fragments;
  if (request.fragments) fragments = visible_fragments(scene);
  return drawn(scene, model, visible_lines(scene, request.lines), fragments, request, merge, nullptr);
}

Drawn in_tiles(const Model& model, const View& view, const ImageTiles& tiles, const TileRequest& request, Merge merge) {
  std::vector<ModelPart> parts = parts_of(model, view, tiles);
  std::vector<TilePart> found;
  for (std::uint32_t t = 0; t < tiles.count(); ++t) found.push_back(lines_of_tile(parts[t], view, tiles, t, request));
  std::reverse(found.begin(), found.end());
  const UnitedTiles all = united_tiles(std::move(found), view, tiles, request.only_visible);
  return drawn(SceneView(all.mesh, view), all.part.model, all.lines, all.fragments, request, merge, &all.part);
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

}  // namespace

Model model_of(const scenes::TestScene& scene) {
  Model model;
  model.points = scene.points;
  for (Point3& p : model.points) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  model.polygons = scene.polygons;
  return model;
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

std::string wrong_with(const Model& model, const View& view, const std::function<ImageTiles()>& tiles,
                       const TileRequest& request, Merge merge) {
  try {
    const Drawn whole = in_one_piece(model, view, request, merge);
    const Drawn united = in_tiles(model, view, tiles(), request, merge);
    ++compared;
    if (whole.json != united.json) return difference(whole.json, united.json);
    if (whole.svg != united.svg) return difference(whole.svg, united.svg);
  } catch (const InputError& e) {
    std::string text = e.what();
    if (text.find("as many faces coincide") != std::string::npos) return {};
    if (text.starts_with("scale: ") || text.starts_with("tiles: the picture")) return {};
    return text;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what();
  }
  return {};
}

int compared_scenes() { return compared; }

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

void agree_on(const std::string& name, std::uint64_t first_seed, int count, const Wanted& wanted) {
  const scenes::Family& family = scenes::family(name);
  int failures = 0;
  const auto end = first_seed + static_cast<std::uint64_t>(count * more_scenes());
  for (std::uint64_t seed = first_seed; seed < end && failures < 3; ++seed) {
    TileRequest request;
    request.only_visible = wanted.only_visible;
    request.fragments = wanted.fragments;
    if (!wanted.only_visible || seed % 2 == 0) request.lines.classes.fill(true);
    if (seed % 3 == 1) request.lines.method = LineMethod::roberts;
    if (seed % 3 == 2) request.lines.method = LineMethod::appel;
    scenes::TestScene scene = family.make(seed);
    const auto tiles = static_cast<std::uint32_t>(1 + seed % 7);
    const auto wrong = [&](const scenes::TestScene& s) {
      Model model = model_of(s);
      if (wanted.fragments) give_colours(model, 2);
      return wrong_with(
          model, s.view, [&] { return tiles_for(model, s.view, tiles); }, request, merge_of(seed));
    };
    if (wrong(scene).empty()) continue;
    ++failures;
    scene = scenes::shrunk(scene, [&](const scenes::TestScene& s) { return !wrong(s).empty(); });
    FAIL_CHECK(name << " " << seed << ", " << tiles << " tiles:\n" << scenes::to_text(scene) << wrong(scene));
  }
  CHECK(failures == 0);
}

void give_colours(Model& model, std::uint32_t count) {
  for (std::uint32_t k = 0; k < count; ++k) model.palette.push_back({static_cast<std::uint8_t>(250 - 40 * k), 200, 180, 255});
  for (std::uint32_t f = 0; f < model.polygons.size(); ++f) model.face_colour.push_back(f % count);
}

Merge merge_of(std::uint64_t seed) {
  constexpr Merge all[] = {Merge::none, Merge::coplanar, Merge::colour};
  return all[seed % 3];
}

}  // namespace hsr::tiles_tests
