#pragma once

#include <cstddef>

#include "hsr/raster/z_buffer.h"

namespace hsr::internal {

/// The picture of a z-buffer of one row, and what it took.
template <class Real>
struct RowZBuffer {
  DepthImage<Real> image;
  std::size_t most_active = 0;  ///< triangles that one row crosses
  std::size_t bytes = 0;        ///< working storage beside the picture: corners, buckets, active triangles, a row of depths
};

/// The scanline z-buffer: rows from the top, each with the triangles that cross it, over depths of one row only. Triangles wait
/// in a bucket for their first row, then are active until their last.
///
///   (1) the same picture as z_buffer() with the same Real, to the bit
///
/// Exact: no. Cost: O(n + crossings of triangles and rows + samples drawn); one thread, but for the corners.
/// Source: Myers 1975; Rogers 1985, "scan line z-buffer".
template <class Real>
RowZBuffer<Real> row_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties = {});

extern template RowZBuffer<float> row_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
extern template RowZBuffer<double> row_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);

}  // namespace hsr::internal
