#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace hsr::internal::read {

/// The texels of a texture, row by row from the top: red, green, blue and opacity, in sRGB.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  const std::uint8_t* texel(std::size_t x, std::size_t y) const { return &rgba[4 * (y * width + x)]; }
};

/// A picture in a PNG or a JPEG file; nothing for another format, a damaged one, or more than 2^26 texels.
std::optional<Picture> decode_picture(const std::vector<unsigned char>& bytes);

}  // namespace hsr::internal::read
