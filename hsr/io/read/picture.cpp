#include "hsr/io/read/picture.h"

#include <png.h>

#include <csetjmp>
#include <cstdio>

// After <cstdio>, which it does not include itself.
// clang-format off
#include <jpeglib.h>
// clang-format on

namespace hsr::internal::read {

namespace {

constexpr std::size_t most_texels = std::size_t{1} << 26;

std::optional<Picture> decode_png(const std::vector<unsigned char>& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return {};
  image.format = PNG_FORMAT_RGBA;
  Picture picture{image.width, image.height, {}};
  if (picture.width > most_texels / picture.height) {
    png_image_free(&image);
    return {};
  }
  picture.rgba.resize(4 * picture.width * picture.height);
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0) return {};
  return picture;
}

/// What libjpeg jumps back to when it meets an error.
struct JpegErrors {
  jpeg_error_mgr manager;  // first: libjpeg knows only of this
  std::jmp_buf back;
};

void leave(j_common_ptr info) { std::longjmp(reinterpret_cast<JpegErrors*>(info->err)->back, 1); }
void say_nothing(j_common_ptr) {}

/// Rows as libjpeg gives them, three bytes a texel; false if the file is damaged.
/// Nothing here has a destructor: an error jumps out of it.
bool read_jpeg(jpeg_decompress_struct& info, JpegErrors& errors, const std::vector<unsigned char>& bytes, Picture& picture,
               std::vector<std::uint8_t>& row) {
  info.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = leave;
  errors.manager.output_message = say_nothing;
  if (setjmp(errors.back) != 0) return false;
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, bytes.data(), bytes.size());
  if (jpeg_read_header(&info, TRUE) != JPEG_HEADER_OK) return false;
  info.out_color_space = JCS_RGB;
  if (info.image_width > most_texels / info.image_height) return false;
  jpeg_start_decompress(&info);
  picture.width = info.output_width;
  picture.height = info.output_height;
  picture.rgba.assign(4 * picture.width * picture.height, 255);
  row.resize(3 * picture.width);
  while (info.output_scanline < info.output_height) {
    std::uint8_t* to = &picture.rgba[4 * picture.width * info.output_scanline];
    JSAMPROW rows[] = {row.data()};
    jpeg_read_scanlines(&info, rows, 1);
    for (std::size_t x = 0; x < picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) to[4 * x + c] = row[3 * x + c];
  }
  return true;
}

std::optional<Picture> decode_jpeg(const std::vector<unsigned char>& bytes) {
  jpeg_decompress_struct info = {};
  JpegErrors errors;
  Picture picture;
  std::vector<std::uint8_t> row;
  const bool is_read = read_jpeg(info, errors, bytes, picture, row);
  jpeg_destroy_decompress(&info);
  if (!is_read) return {};
  return picture;
}

}  // namespace

std::optional<Picture> decode_picture(const std::vector<unsigned char>& bytes) {
  if (bytes.size() < 8) return {};
  if (bytes[0] == 0x89 && bytes[1] == 'P') return decode_png(bytes);
  if (bytes[0] == 0xff && bytes[1] == 0xd8) return decode_jpeg(bytes);
  return {};
}

}  // namespace hsr::internal::read
