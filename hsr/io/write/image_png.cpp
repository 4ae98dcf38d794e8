#include "hsr/io/write/image_png.h"

#include <png.h>

#include <cstdint>
#include <cstring>
#include <limits>

#include "geometry/error.h"

namespace hsr::internal {

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

}  // namespace hsr::internal
