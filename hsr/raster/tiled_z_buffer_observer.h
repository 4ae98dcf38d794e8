#pragma once

#include <span>

#include "hsr/raster/nearness_sample.h"
#include "hsr/raster/tiled_z_buffer.h"

namespace hsr::internal {

/// Samples left ... right - 1 of rows top ... bottom - 1.
struct SampleTile {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Is told what the z-buffer in tiles does, in the order in which it does it.
class TiledZBufferObserver {
 public:
  TiledZBufferObserver() = default;
  TiledZBufferObserver(const TiledZBufferObserver&) = delete;
  TiledZBufferObserver& operator=(const TiledZBufferObserver&) = delete;
  virtual ~TiledZBufferObserver() = default;

  /// A tile begins; all triangles are sorted. @param triangles its list, by their numbers: those whose boxes reach into it
  virtual void tile(const SampleTile& tile, std::span<const TriangleId> triangles) = 0;
  /// Of a triangle the samples begin ... end - 1, which are in the tile; samples of them follow from the left.
  virtual void span(TriangleId t, int row, int begin, int end) = 0;
  virtual void sample(const NearnessSample& sample) = 0;
  /// The tile is copied into the picture.
  virtual void done() = 0;
};

/// Tiles that can be followed; unwatched they are of 64 x 64 samples.
constexpr int watched_tile_size = 8;

/// tiled_z_buffer() in floats, watched, tile by tile in one thread and with tiles of `watched_tile_size`: it gives the same picture.
TiledZBuffer<float> tiled_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties,
                                   TiledZBufferObserver& observer);

}  // namespace hsr::internal
