#pragma once

#include <cstdint>
#include <span>

#include "hsr/raster/a_buffer.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

/// A fragment in the list of a pixel.
struct PixelFragment {
  FacetId facet;
  std::uint32_t mask = 0;  ///< bit 8 v + u: the sample in row v and column u of the pixel is covered
  double nearness = 0;     ///< the mean over the samples of the mask; larger is nearer
};

/// Is told what the A-buffer does, in the order in which it does it.
class ABufferObserver {
 public:
  ABufferObserver() = default;
  ABufferObserver(const ABufferObserver&) = delete;
  ABufferObserver& operator=(const ABufferObserver&) = delete;
  virtual ~ABufferObserver() = default;

  /// A pixel's list has this fragment now: a new one, or the latest one with more samples.
  virtual void added(int column, int row, const PixelFragment& fragment, bool is_new) = 0;
  /// A pixel is resolved: its fragments, the nearest first.
  virtual void sorted(int column, int row, std::span<const PixelFragment> fragments) = 0;
  /// The next fragment. @param share of the pixel's light that is its, 0 ... 1 @param open the samples where light from behind
  /// still gets through
  virtual void took(const PixelFragment& fragment, float opacity, float share, std::uint32_t open) = 0;
  /// All of the light. @param background the share that is the background's
  virtual void resolved(int column, int row, float background, const Colour& colour) = 0;
};

/// a_buffer(), watched: it does the same and gives the same.
ABuffer a_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                 double opacity, TieRule ties, ABufferObserver& observer);

}  // namespace hsr::internal
