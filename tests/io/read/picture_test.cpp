#include "hsr/io/read/picture.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>

// After <cstdio>, which it does not include itself.
// clang-format off
#include <jpeglib.h>
// clang-format on

using namespace hsr::internal::read;

namespace {

/// A grey JPEG of 16 x 8 texels.
std::vector<unsigned char> grey_jpeg() {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = 16;
  info.image_height = 8;
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_start_compress(&info, TRUE);
  std::vector<JSAMPLE> row(48, 128);
  JSAMPROW rows[] = {row.data()};
  while (info.next_scanline < info.image_height) jpeg_write_scanlines(&info, rows, 1);
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::vector<unsigned char> jpeg(bytes, bytes + size);
  std::free(bytes);
  return jpeg;
}

}  // namespace

TEST_CASE("A JPEG is decoded, and one that is damaged gives a picture or none", "[read][gltf][picture]") {
  const std::vector<unsigned char> jpeg = grey_jpeg();
  const std::optional<Picture> picture = decode_picture(jpeg);
  REQUIRE(picture);
  CHECK(picture->width == 16);
  CHECK(picture->height == 8);
  for (const std::size_t i : {0U, 1U, 2U, 509U, 510U}) CHECK(picture->rgba[i] == 128);
  CHECK(picture->texel(15, 7)[3] == 255);
  CHECK_FALSE(decode_picture({1, 2, 3}));
  CHECK_FALSE(decode_picture(std::vector<unsigned char>(100, 'x')));
  for (std::size_t n = 0; n < jpeg.size(); ++n)
    (void)decode_picture({jpeg.begin(), jpeg.begin() + static_cast<std::ptrdiff_t>(n)});
  for (std::size_t i = 2; i < jpeg.size(); ++i) {
    std::vector<unsigned char> changed = jpeg;
    changed[i] ^= 0x5a;
    (void)decode_picture(changed);
  }
}
