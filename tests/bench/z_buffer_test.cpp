#include "bench/peers/z_buffer.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

using hsr::VertexId;
using hsr::bench::PixelPoint;
using hsr::bench::ZBuffer;

namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

/// Two triangles over four points from `first` on, in a ring.
void add_square(Triangles& triangles, std::size_t first) {
  triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  triangles.push_back({VertexId(first), VertexId(first + 2), VertexId(first + 3)});
}

/// A row of text for each row of pixels: the triangle, or a dot for none.
std::string picture(const ZBuffer& z) {
  std::string text;
  for (int j = 0; j < z.height; ++j, text += '\n')
    for (int i = 0; i < z.width; ++i)
      text += z.at(i, j).triangle == 0xffffffffU ? '.' : static_cast<char>('0' + z.at(i, j).triangle);
  return text;
}

}  // namespace

TEST_CASE("the z-buffer shows the nearer of two squares where they overlap", "[bench][z-buffer]") {
  // The nearer square comes first in one order and last in the other.
  const std::vector<PixelPoint> points = {{1, 1, 2}, {5, 1, 2}, {5, 5, 2}, {1, 5, 2},
                                          {3, 2, 1}, {7, 2, 1}, {7, 6, 1}, {3, 6, 1}};
  Triangles triangles;
  add_square(triangles, 0);
  add_square(triangles, 4);
  ZBuffer z(8, 7);
  z.draw(points, triangles);
  CHECK(picture(z) ==
        "........\n"
        ".0000...\n"
        ".100022.\n"
        ".110022.\n"
        ".111022.\n"
        "...3332.\n"
        "........\n");
  CHECK(z.at(1, 1).nearness == 2);
  CHECK(z.at(6, 2).nearness == 1);

  z.clear();
  CHECK(picture(z).find_first_not_of(".\n") == std::string::npos);
  Triangles turned;
  add_square(turned, 4);
  add_square(turned, 0);
  z.draw(points, turned);
  CHECK(picture(z) ==
        "........\n"
        ".2222...\n"
        ".322200.\n"
        ".332200.\n"
        ".333200.\n"
        "...1110.\n"
        "........\n");
}

TEST_CASE("of two triangles that pierce each other the z-buffer shows the nearer half of each", "[bench][z-buffer]") {
  // One falls and one rises along x; they are equally near at x = 4.
  const std::vector<PixelPoint> points = {{0, 0, 8}, {8, 0, 0}, {8, 8, 0}, {0, 8, 8},
                                          {0, 0, 0}, {8, 0, 8}, {8, 8, 8}, {0, 8, 0}};
  Triangles triangles;
  add_square(triangles, 0);
  add_square(triangles, 4);
  ZBuffer z(8, 8);
  z.draw(points, triangles);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      CAPTURE(i, j);
      CHECK(z.at(i, j).triangle / 2 == (i < 4 ? 0U : 1U));
      CHECK(z.at(i, j).nearness == Approx(std::fabs(i + 0.5 - 4) + 4));
    }
}

TEST_CASE("triangles that share edges leave no gap in the z-buffer, and what is outside is cut", "[bench][z-buffer]") {
  // A fan about a point off the samples' grid, larger than the picture.
  std::vector<PixelPoint> points = {{15.3F, 16.2F, 1}};
  Triangles triangles;
  for (std::size_t k = 0; k < 7; ++k) {
    const double angle = static_cast<double>(k) * 2 * 3.14159265358979 / 7;
    points.push_back({static_cast<float>(15.3 + 60 * std::cos(angle)), static_cast<float>(16.2 + 60 * std::sin(angle)), 1});
    triangles.push_back({VertexId(0), VertexId(1 + k), VertexId(1 + (k + 1) % 7)});
  }
  ZBuffer z(32, 32);
  z.draw(points, triangles);
  CHECK(picture(z).find('.') == std::string::npos);
}

TEST_CASE("a triangle between the samples, or without area, draws nothing", "[bench][z-buffer]") {
  const std::vector<PixelPoint> points = {{2.6F, 2.6F, 1}, {3.4F, 2.7F, 1}, {3, 3.4F, 1}, {0, 0, 1}, {4, 4, 1}, {8, 8, 1}};
  const Triangles triangles = {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(4), VertexId(5)}};
  ZBuffer z(8, 8);
  z.draw(points, triangles);
  CHECK(picture(z).find_first_not_of(".\n") == std::string::npos);
}
