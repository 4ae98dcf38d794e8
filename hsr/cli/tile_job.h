#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hsr/cli/line_arguments.h"
#include "hsr/cli/view_options.h"
#include "hsr/io/write/output_file.h"
#include "hsr/model.h"
#include "hsr/tiles/image_tiles.h"
#include "hsr/tiles/tile_lines.h"

namespace hsr::cli {

using namespace internal;

/// One scene in tiles, as it lies in a directory: job.json says all that the tiles have in common, tile-N has the faces of a tile, and
/// part-N its lines and fills, once they are found. See docs/tiles.md, "Files".
struct TileJob {
  struct Tile {
    std::uint64_t faces = 0, bytes = 0;
    std::string hash;  ///< of the file
  };

  std::string directory;
  std::string hash;  ///< of all below
  Model names;       ///< without points and faces: its name, unit, and the names of objects, materials and colours
  ChosenView chosen;
  std::string unit;  ///< asked for; empty: the model's
  LineArguments lines;
  std::string coplanar, hidden = "none";
  bool is_complete = false;  ///< with what is hidden, as JSON has it
  bool has_fills = false;    ///< with what is seen of each face
  ImageTiles image;
  std::vector<Tile> tiles;

  TileRequest request() const;
  /// "tile-3" of the first three is the last: people count from 1.
  std::string tile_path(std::uint32_t tile) const;
  std::string part_path(std::uint32_t tile) const;
};

/// Writes job.json, when all tiles are there. Sets its hash.
void write_job(TileJob& job, UnfinishedFiles& unfinished);
/// @throws InputError where there is none, or its hash is not that of what it says
TileJob read_job(const std::string& directory);

/// Writes the faces of a tile, and says in the job what they are.
void write_tile(TileJob& job, std::uint32_t tile, const ModelPart& part, UnfinishedFiles& unfinished);
/// @throws InputError naming the file where it is not the one that the job was split into
ModelPart read_tile(const TileJob& job, std::uint32_t tile);

/// Under a temporary name, synced and renamed, so that it is there whole or not at all.
void write_part(const TileJob& job, std::uint32_t tile, const TilePart& part, UnfinishedFiles& unfinished);
/// What is wrong with the part of a tile; nothing: it is there, whole, and of this job.
std::optional<std::string> wrong_with_part(const TileJob& job, std::uint32_t tile);
/// @pre nothing is wrong with it
TilePart read_part(const TileJob& job, std::uint32_t tile);

}  // namespace hsr::cli
