#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/tiles/line_piece.h"
#include "hsr/tiles/used_parts.h"

namespace hsr::internal {

/// What of the visible fragments lies in one tile.
struct TileFragments {
  VisibleFragments whole;       ///< of facets that no side of the tile cuts
  std::vector<FacetId> facets;  ///< of the others, ascending
  Ragged<MapSide>
      sides;  ///< by facet, what bounds it in the tile; along a side of the tile, where it goes on beyond, by name of that
};

/// @param found of the scene of the tile, whether in the tile or not @param names of the scene's mesh
/// Exact: yes. Cost: a sign for each corner of a facet, and for each side of fragments that a side of the tile may cut.
TileFragments fragments_in_tile(const SceneView& scene, const VisibleFragments& found, const std::vector<TileBound>& bounds,
                                const Names& names);

/// By name, as bytes: facet by facet, the numbers as how far each is from the one before.
/// @param mesh of the tile @param used is told what of the model they name
std::string bytes_of(const TileFragments& fragments, const Mesh& mesh, const Names& names, UsedParts& used);
/// @param names of any part that has what they name
/// @throws InputError where the bytes are not of this layout, or the part lacks something
TileFragments tile_fragments_of(std::string_view bytes, const Names& names);

}  // namespace hsr::internal
