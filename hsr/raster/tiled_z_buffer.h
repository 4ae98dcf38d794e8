#pragma once

#include <cstddef>

#include "hsr/raster/z_buffer.h"

namespace hsr::internal {

/// The picture of a z-buffer in tiles, and what it took.
template <class Real>
struct TiledZBuffer {
  DepthImage<Real> image;
  std::size_t entries = 0;  ///< of triangles in tiles
  std::size_t bytes = 0;    ///< working storage beside the picture: corners, lists of the tiles, a buffer for each thread
};

/// The windowed z-buffer: triangles are first sorted into tiles of 64 x 64 samples, then each tile is drawn in a buffer of its
/// own that stays in the nearest cache. Tiles in parallel; of floats, four samples of a span side by side.
///
///   (1) the same picture as z_buffer() with the same Real, to the bit, for any number of threads
///
/// Exact: no. Cost: O(n + entries + samples drawn).
/// Source: Fuchs et al. 1989 (Pixel-Planes 5, regions of the screen); Molnar, Cox, Ellsworth & Fuchs 1994 (sort-middle).
template <class Real>
TiledZBuffer<Real> tiled_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties = {});

extern template TiledZBuffer<float> tiled_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
extern template TiledZBuffer<double> tiled_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);

}  // namespace hsr::internal
