#include <png.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numeric>

#include "hsr/drawing/drawing.h"
#include "hsr/image/image.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/write/png.h"
#include "hsr/write/svg.h"
#include "tests/scenes/test_scene.h"

namespace hsr {
namespace {

Image<std::uint8_t> read_grey(const std::string& bytes) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0);
  png.format = PNG_FORMAT_GRAY;
  Image<std::uint8_t> image(static_cast<int>(png.width), static_cast<int>(png.height));
  REQUIRE(png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) != 0);
  return image;
}

/// A fan of triangles around a point, with a smaller one turned before it.
scenes::TestScene fans() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  for (int layer = 0; layer < 2; ++layer)
    for (int k = 0; k < 37; ++k) {
      const auto rim = [&](int i) {
        const double a = 2 * 3.14159 * (i % 37) / 37 + 0.1 * layer, r = layer == 0 ? 10 : 6;
        return Point3{r * std::cos(a) + layer, r * std::sin(a), static_cast<double>(layer)};
      };
      scene.add_face({Point3{0.3 + layer, 0.2, static_cast<double>(layer)}, rim(k), rim(k + 1)});
    }
  return scene;
}

Drawing filled(const scenes::TestScene& scene, const std::vector<Colour>& colours, Merge merge) {
  const Mesh mesh = scene.mesh();
  const Regions regions = regions_of(mesh, scene.view, visible_fragments(mesh, scene.view), colours, merge);
  Drawing drawing = draw(mesh, scene.view, visible_lines(mesh, scene.view), {}, &regions);
  drawing.polylines.clear();
  return drawing;
}

TEST_CASE("no seam shows between fills of one colour", "[drawing][fills]") {
  const scenes::TestScene scene = fans();
  const std::vector<Colour> black(scene.polygons.size(), Colour{0, 0, 0, 255});
  const Drawing parts = filled(scene, black, Merge::none), whole = filled(scene, black, Merge::colour);
  REQUIRE(whole.fills.fills.size() == 1);
  REQUIRE(parts.fills.fills.size() > 70);
  for (const PixelSize size : {PixelSize{97, 131}, PixelSize{500, 700}, PixelSize{1301, 1777}}) {
    const Image<std::uint8_t> found = read_grey(png(parts, size)), expected = read_grey(png(whole, size));
    std::size_t inside = 0, shining = 0;
    // Not on the rim, where a pixel may be covered but for a thousandth.
    for (int j = 1; j + 1 < expected.height; ++j)
      for (int i = 1; i + 1 < expected.width; ++i) {
        if (expected.at(i, j) + expected.at(i - 1, j) + expected.at(i + 1, j) + expected.at(i, j - 1) + expected.at(i, j + 1) >
            0)
          continue;
        ++inside;
        if (found.at(i, j) != 0) ++shining;
      }
    CHECK(inside > expected.pixels.size() / 4);
    CHECK(shining == 0);
  }
}

TEST_CASE("merging unites what is of one colour, and in one plane", "[drawing][fills]") {
  const scenes::TestScene scene = fans();
  std::vector<Colour> colours(scene.polygons.size(), Colour{9, 9, 9, 255});
  CHECK(filled(scene, colours, Merge::coplanar).fills.fills.size() == 2);
  CHECK(filled(scene, colours, Merge::colour).fills.fills.size() == 1);
  std::fill(colours.begin(), colours.begin() + 37, Colour{200, 9, 9, 255});
  const Drawing two = filled(scene, colours, Merge::colour);
  REQUIRE(two.fills.fills.size() == 2);
  CHECK(two.fills.fills[0].end_ring - two.fills.fills[0].first_ring == 2);  // the lower one, around the upper
  CHECK(two.fills.fills[0].end_face - two.fills.fills[0].first_face == 37);
  const std::string text = svg(two);
  CHECK(text.find("fill=\"#c80909\"") != std::string::npos);
  CHECK(text.find("clip-path=\"url(#outline)\"") != std::string::npos);
}

}  // namespace
}  // namespace hsr
