#pragma once

#include <string>
#include <string_view>

#include "hsr/tiles/line_piece.h"
#include "hsr/tiles/model_part.h"

namespace hsr::internal {

/// A part of a model as bytes (docs/tiles.md, "Files"), without the names of objects, materials and colours, which all parts share.
std::string bytes_of(const ModelPart& part);
/// @throws InputError where the bytes are not of this layout
ModelPart model_part_of(std::string_view bytes);

/// The lines of a tile likewise.
std::string bytes_of(const TilePart& part);
/// @throws InputError where the bytes are not of this layout
TilePart tile_part_of(std::string_view bytes);

}  // namespace hsr::internal
