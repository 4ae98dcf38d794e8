#pragma once

#include <string>

#include "hsr/image/image.h"
#include "hsr/model.h"

namespace hsr {

/// The bytes of a PNG file: 8 bits each of red, green, blue and opacity, sRGB.
/// @throws InputError if the picture is empty, or too large for the format or for memory
std::string image_png(const Image<Colour>& image);

/// A picture of n x n samples to a pixel made smaller: each pixel is the mean of its samples, rounded to nearest; colours count
/// by their opacity. For display: it softens edges, and is exact no longer.
/// @throws PreconditionError unless n > 0 divides width and height
Image<Colour> box_filtered(const Image<Colour>& samples, int n);

}  // namespace hsr
