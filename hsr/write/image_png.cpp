#include "hsr/write/image_png.h"

#include <png.h>

#include <cstdint>
#include <cstring>
#include <limits>

#include "geometry/error.h"

namespace hsr {

std::string image_png(const Image<Colour>& image) {
  static_assert(sizeof(Colour) == 4);
  const auto fail = [&](const std::string& why) {
    throw InputError("png: found a picture of " + std::to_string(image.width) + "x" + std::to_string(image.height) + ", " +
                     why);
  };
  // The simplified interface of libpng counts the bytes of a picture in 32 bits.
  if (image.pixels.empty()) fail("expected one that is not empty");
  if (image.pixels.size() > std::numeric_limits<std::uint32_t>::max() / sizeof(Colour) / 2)
    fail("expected at most half a thousand million samples");
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) != 0) {
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
  }
  const std::string why = png.message;
  png_image_free(&png);
  fail(why);
  return {};
}

Image<Colour> box_filtered(const Image<Colour>& samples, int n) {
  require(n > 0 && samples.width % n == 0 && samples.height % n == 0, "box_filtered: whole pixels of samples expected");
  Image<Colour> pixels(samples.width / n, samples.height / n);
  const auto count = static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
  for (int j = 0; j < pixels.height; ++j)
    for (int i = 0; i < pixels.width; ++i) {
      std::uint64_t opacity = 0;
      std::array<std::uint64_t, 3> sum = {0, 0, 0};
      for (int y = j * n; y < (j + 1) * n; ++y)
        for (int x = i * n; x < (i + 1) * n; ++x) {
          const Colour& c = samples.at(x, y);
          opacity += c[3];
          for (std::size_t k = 0; k < 3; ++k) sum[k] += static_cast<std::uint64_t>(c[k]) * c[3];
        }
      if (opacity == 0) continue;
      Colour& c = pixels.at(i, j);
      for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::uint8_t>((sum[k] + opacity / 2) / opacity);
      c[3] = static_cast<std::uint8_t>((opacity + count / 2) / count);
    }
  return pixels;
}

}  // namespace hsr
