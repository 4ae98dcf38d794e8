#pragma once

#include <vector>

#include "hsr/scene/projected_mesh.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/tiles/line_piece.h"

namespace hsr::internal {

/// Puts the fragments of all tiles together: those of the whole, ring by ring as visible_fragments() has them, but perhaps with corners
/// by other names. What bounds a facet along a side of tiles goes, as the tile on the other side has it the other way round; a part that
/// stays proves that a tile is missing, old or of another scene.
/// @param parts one for each tile; their fragments are given up @param names of the mesh that is projected
/// @throws TileMismatch, InputError where parts are not of one model
/// Exact: yes. Cost: that of reading them, and of linking the sides of facets that are in several tiles (rings.h).
VisibleFragments united_fragments(std::vector<TilePart>& parts, const Names& names, const ProjectedMesh& projected);

}  // namespace hsr::internal
