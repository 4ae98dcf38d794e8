#pragma once

#include <optional>
#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Pixels.
struct PixelSize {
  int width = 0, height = 0;
};

/// "WIDTHxHEIGHT" @throws InputError for anything else, or more than 32767 either way
PixelSize parse_size(const std::string& text);

/// A drawing as a PNG file, with the pens of the SVG on white. Without a size 150 dots to the inch, but never beyond 16384
/// pixels either way; with one the page is scaled to fit it and centred.
/// @throws InputError if the picture does not fit into memory
std::string png(const Drawing& drawing, std::optional<PixelSize> size = {});

}  // namespace hsr::internal
