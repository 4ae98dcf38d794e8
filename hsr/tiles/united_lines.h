#pragma once

#include <cstdint>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/tiles/line_piece.h"
#include "hsr/tiles/tile_mismatch.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// The lines and fragments of all tiles, and the part of the model that they name. The numbers of the mesh are those of the part, in the
/// same order as those of the whole.
struct UnitedTiles {
  ModelPart part;
  Mesh mesh;
  VisibleLines lines;
  VisibleFragments fragments;  ///< none, where they were not asked for
};

/// Puts the pieces of all tiles together: the lines of the whole, item by item as visible_lines() has them, or of parts with only what is
/// visible, as a drawing of them has them; and the fragments (united_fragments.h). A cut at a side of tiles goes; one that would stay proves
/// that a tile is missing, old or of another scene.
/// @param parts one for each tile, in any order @param only_visible as they were asked for
/// @throws TileMismatch, InputError where parts are not of one model
/// Exact: yes. Cost: O(n log n) for n pieces.
UnitedTiles united_tiles(std::vector<TilePart> parts, const View& view, const ImageTiles& tiles, bool only_visible);

}  // namespace hsr::internal
