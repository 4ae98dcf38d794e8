#pragma once

#include <span>

#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/compositing.h"

namespace hsr::internal {

/// A layer in the list of a sample; larger is nearer.
struct SampleLayer {
  double nearness = 0;
  TriangleId triangle;
};

/// Is told what the alpha-buffer does, in the order in which it does it.
class AlphaBufferObserver {
 public:
  AlphaBufferObserver() = default;
  AlphaBufferObserver(const AlphaBufferObserver&) = delete;
  AlphaBufferObserver& operator=(const AlphaBufferObserver&) = delete;
  virtual ~AlphaBufferObserver() = default;

  /// A layer comes into the list of a sample.
  virtual void added(int column, int row, const SampleLayer& layer) = 0;
  /// The layers of a sample, from far to near.
  virtual void sorted(int column, int row, std::span<const SampleLayer> layers) = 0;
  /// The next of them is laid over what is there.
  virtual void laid_over(const SampleLayer& layer, float opacity, const Light& before, const Light& after) = 0;
  virtual void blended(int column, int row, const Colour& colour) = 0;
};

/// alpha_buffer(), watched: it does the same and gives the same.
AlphaBuffer alpha_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                         double opacity, TieRule ties, AlphaBufferObserver& observer);

}  // namespace hsr::internal
