#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/model.h"
#include "hsr/tiles/ascending_numbers.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/view/view.h"

namespace hsr::cli {

using namespace internal;

/// Lets each corner and end of a wire name the lowest of the points that are bit for bit the same, -0 being 0: what a Mesh has as
/// `merged`. Changes -0 to 0.
void name_merged_points(Model& model);

/// A few wires whose bounding box is that of all edges of the model's mesh, without that mesh being made.
Mesh bounding_mesh(const Model& model);

/// Tiles with about as many faces each.
ImageTiles tiles_of(const Model& model, const View& view, std::uint32_t count);

/// The faces and wires that may reach into each tile.
struct TileContents {
  std::vector<AscendingNumbers> faces, segments;
};
TileContents contents_of_tiles(const Model& model, const View& view, const ImageTiles& tiles);

}  // namespace hsr::cli
