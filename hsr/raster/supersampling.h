#pragma once

#include "geometry/error.h"
#include "hsr/image.h"
#include "hsr/model.h"
#include "hsr/raster/samples.h"

namespace hsr::internal {

/// A picture of n x n samples to a pixel made smaller: each pixel is the mean of its samples, rounded to nearest; colours count
/// by their opacity. For display: it softens edges, and is exact no longer.
/// @throws PreconditionError unless n > 0 divides width and height
Image<Colour> box_filtered(const Image<Colour>& samples, int n);

/// A picture by any method, with n x n samples to a pixel.
///
/// @param grid_of gives the samples of a picture of so many samples: grid_of(width, height)
/// @param draw gives the colours of a method at these: draw(grid) -> Image<Colour>
/// @throws PreconditionError unless n is 1 ... 8
/// Cost: n^2 times that of the method's samples.
/// Source: Crow 1977, "The aliasing problem in computer-generated shaded images".
template <class GridOf, class Draw>
Image<Colour> supersampled(int width, int height, int n, const GridOf& grid_of, const Draw& draw) {
  require(n >= 1 && n <= 8, "supersampled: 1 to 8 samples each way expected");
  return box_filtered(draw(grid_of(n * width, n * height)), n);
}

}  // namespace hsr::internal
