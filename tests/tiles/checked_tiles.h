#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hsr/model.h"
#include "hsr/surfaces/regions.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/tiles/model_part.h"
#include "hsr/tiles/tile_lines.h"
#include "tests/scenes/test_scene.h"

namespace hsr::tiles_tests {

Model model_of(const scenes::TestScene& scene);
/// So many, in turn.
void give_colours(Model& model, std::uint32_t count);

/// What each tile takes.
std::vector<internal::ModelPart> parts_of(const Model& model, const View& view, const internal::ImageTiles& tiles);
internal::ImageTiles tiles_for(const Model& model, const View& view, std::uint32_t count);
/// Columns that end at these places of the frame, each in rows that end at others, moved by `shift` from column to column.
internal::ImageTiles grid(const View& view, const std::vector<double>& columns, const std::vector<double>& rows, double shift);

/// How the drawing in tiles differs from the one in one piece, SVG, and JSON with exact numbers; "" where they are the same, or where
/// tiles are refused for what only the whole scene tells.
std::string wrong_with(const Model& model, const View& view, const std::function<internal::ImageTiles()>& tiles,
                       const internal::TileRequest& request, Merge merge = Merge::none);
/// Scenes of which wrong_with() saw both drawings.
int compared_scenes();

struct Wanted {
  bool only_visible = false, fragments = false;
};
/// Checks that nothing is wrong with scenes of a family, in 1 to 7 tiles.
void agree_on(const std::string& name, std::uint64_t first_seed, int count, const Wanted& wanted);
/// One way of merging after the other.
Merge merge_of(std::uint64_t seed);

}  // namespace hsr::tiles_tests
