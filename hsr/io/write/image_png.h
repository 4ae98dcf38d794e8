#pragma once

#include <string>

#include "hsr/image.h"
#include "hsr/model.h"

namespace hsr::internal {

/// The bytes of a PNG file: 8 bits each of red, green, blue and opacity, sRGB.
/// @throws InputError if the picture is empty, or too large for the format or for memory
std::string image_png(const Image<Colour>& image);

}  // namespace hsr::internal
