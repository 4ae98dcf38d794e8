#pragma once

#include <span>

#include "hsr/raster/nearness_sample.h"
#include "hsr/raster/row_z_buffer.h"

namespace hsr::internal {

/// Is told what the z-buffer of one row does, in the order in which it does it.
class RowZBufferObserver {
 public:
  RowZBufferObserver() = default;
  RowZBufferObserver(const RowZBufferObserver&) = delete;
  RowZBufferObserver& operator=(const RowZBufferObserver&) = delete;
  virtual ~RowZBufferObserver() = default;

  /// A triangle waits in the bucket of its first row.
  virtual void waits(TriangleId t, int first_row) = 0;
  /// A row begins with an empty buffer, and with the triangles that may cross it.
  virtual void row(int row, std::span<const TriangleId> active) = 0;
  /// Of an active triangle the samples begin ... end - 1; samples of them follow from the left.
  virtual void span(TriangleId t, int row, int begin, int end, bool is_last_row) = 0;
  virtual void sample(const NearnessSample& sample) = 0;
};

/// row_z_buffer() in doubles, watched: it does the same and gives the same.
RowZBuffer<double> row_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties,
                                RowZBufferObserver& observer);

}  // namespace hsr::internal
