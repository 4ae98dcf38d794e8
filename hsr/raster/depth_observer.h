#pragma once

#include <array>

#include "geometry/mesh.h"
#include "hsr/raster/depth_buffer.h"

namespace hsr::internal {

/// A corner as a depth buffer draws it: where it is seen, in samples, and what is interpolated there.
struct DepthCorner {
  double x = 0, y = 0, depth = 0;
};

/// What a depth buffer did at a sample.
struct DepthSample {
  int column = 0, row = 0;
  double depth = 0;        ///< of the triangle there, 0 near ... 1 far, as the format holds it
  double stored = 0;       ///< the number that stands for it: of fixed formats a whole one
  double held = 0;         ///< what the buffer had before, decoded
  double held_stored = 0;  ///< and its number
  bool is_within = true;   ///< between the near and the far plane
  bool is_shown = false;   ///< it passed the test: the buffer has it now
};

/// A side of a triangle that is drawn by increments, where it crosses a row: the column, the depth there, and how both change to the
/// next row. The change of the column is 1/m.
struct DepthSide {
  double x = 0, depth = 0, x_a_row = 0, depth_a_row = 0;
};

/// Is told what a depth buffer does, in the order in which it does it.
class DepthObserver {
 public:
  DepthObserver() = default;
  DepthObserver(const DepthObserver&) = delete;
  DepthObserver& operator=(const DepthObserver&) = delete;
  virtual ~DepthObserver() = default;

  /// All samples hold the depth that the buffer begins with.
  virtual void began(int width, int height, double depth, double stored) = 0;
  /// A triangle that has samples, beyond the near plane. @param right, down how what is interpolated changes from one sample to the
  /// next, and from one row to the next: -A/C and -B/C of its plane
  virtual void triangle(TriangleId t, const std::array<DepthCorner, 3>& corners, double right, double down) = 0;
  /// Where the left and the right side cross a row, before its span; only where depths are interpolated by increments.
  virtual void sides(int /*row*/, const DepthSide& /*left*/, const DepthSide& /*right*/) {}
  /// Of a triangle the samples begin ... end - 1 of a row; samples of them follow from the left.
  virtual void span(int row, int begin, int end) = 0;
  virtual void sample(const DepthSample& sample) = 0;
};

/// depth_buffer(), watched: it does the same and gives the same.
DepthBuffer depth_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                         const DepthBufferOptions& options, DepthObserver& observer);

}  // namespace hsr::internal
