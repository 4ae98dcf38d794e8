#pragma once

#include <cstdint>

#include "hsr/lines/line_options.h"
#include "hsr/scene/scene.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/tiles/line_piece.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What is looked for in each tile of one scene.
struct TileRequest {
  LineOptions lines = {};
  SceneOptions scene = {};
  /// What a drawing without hidden lines takes: the visible pieces, and those that tell how large it is. Else every line as
  /// visible_lines() has it.
  bool only_visible = false;
  bool fragments = false;  ///< with what is seen of each face
};

/// Refuses what cannot be told tile by tile. @throws InputError naming the option
void check_tile_request(const View& view, const TileRequest& request);

/// The pieces in one tile of all lines that are asked for, and of the visible fragments.
///
/// Within a tile all that can hide a point, and all faces that an edge lies in, reach into the tile: so what is visible there of the
/// faces of the tile alone is visible in the whole scene, and has its class there. What is found beyond the sides is cut off, by name.
/// A line that runs in a side is in the tile on the positive side of it.
///
/// @param part all faces and wires that reach into the tile
/// @throws InputError where only faces elsewhere tell what an edge is: all around a part of it as many coincide
/// Exact: yes. Cost: that of the visible lines of the part, and of its visible fragments.
TilePart lines_of_tile(const ModelPart& part, const View& view, const ImageTiles& tiles, std::uint32_t tile,
                       const TileRequest& request);

/// The mesh of a part, with two more points for each side of the tiles, at the ends of an edge of nothing: see Names.
Mesh mesh_with_sides(const ModelPart& part, const ImageTiles& tiles);

}  // namespace hsr::internal
