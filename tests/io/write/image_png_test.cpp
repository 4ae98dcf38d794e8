#include "hsr/io/write/image_png.h"

#include <png.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "geometry/error.h"
#include "hsr/raster/supersampling.h"

namespace hsr {

using namespace internal;

namespace {

Image<Colour> read(const std::string& bytes) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0);
  png.format = PNG_FORMAT_RGBA;
  Image<Colour> image(static_cast<int>(png.width), static_cast<int>(png.height));
  REQUIRE(png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) != 0);
  return image;
}

TEST_CASE("a picture written as PNG reads back as it was", "[write][png]") {
  Image<Colour> image(37, 5);
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i)
      image.at(i, j) = {static_cast<std::uint8_t>(7 * i), static_cast<std::uint8_t>(50 * j), 200,
                        static_cast<std::uint8_t>(255 - i)};
  CHECK(read(image_png(image)) == image);
  CHECK(image_png(image) == image_png(image));
  CHECK_THROWS_AS(image_png(Image<Colour>()), InputError);
}

TEST_CASE("a pixel is the mean of its samples, colours by their opacity", "[write][png]") {
  Image<Colour> samples(4, 2, {10, 20, 30, 255});
  samples.at(0, 0) = {0, 0, 0, 255};
  samples.at(2, 0) = samples.at(3, 0) = samples.at(3, 1) = {99, 99, 99, 0};
  const Image<Colour> pixels = box_filtered(samples, 2);
  REQUIRE(pixels.width == 2);
  REQUIRE(pixels.height == 1);
  CHECK(pixels.at(0, 0) == Colour{8, 15, 23, 255});  // 7.5, 15, 22.5
  CHECK(pixels.at(1, 0) == Colour{10, 20, 30, 64});  // 63.75
  CHECK(box_filtered(samples, 1).at(1, 1) == samples.at(1, 1));
  CHECK_THROWS_AS(box_filtered(samples, 3), PreconditionError);
}

}  // namespace
}  // namespace hsr
