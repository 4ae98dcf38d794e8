#include "hsr/raster/supersampling.h"

#include <catch2/catch.hpp>

#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/z_buffer.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using namespace internal;

namespace {

/// Black from x = 0 to 2.375, of 4 pixels that are one unit wide, seen from above.
struct Stripe {
  scenes::TestScene scene;
  std::vector<Colour> colours = {{0, 0, 0, 255}};

  Stripe() {
    scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
    scene.add_face(std::vector<Point3>{{0, -1, 0}, {2.375, -1, 0}, {2.375, 0, 0}, {0, 0, 0}});
  }
  static SampleGrid grid(int width, int height) {
    const double pixel = 4.0 / width;
    return {{pixel / 2, -pixel / 2, 0}, {pixel, 0, 0}, {0, -pixel, 0}, width, height};
  }
};

TEST_CASE("n x n samples to a pixel tell its covered area in steps of 1 / n along an upright edge", "[image][supersampling]") {
  const Stripe stripe;
  const Mesh mesh = stripe.scene.mesh();
  // Of pixel 2 the part 0.375 is black; n samples are at (k + 1/2) / n, and one on the edge belongs to its right.
  for (const auto& [n, share] : {std::pair(1, 0), std::pair(2, 1), std::pair(4, 1), std::pair(8, 3)}) {
    const Image<Colour> by_alpha = supersampled(4, 1, n, Stripe::grid, [&](const SampleGrid& grid) {
      return alpha_buffer(mesh, stripe.scene.view, grid, stripe.colours, 1).picture;
    });
    const Image<Colour> by_z = supersampled(4, 1, n, Stripe::grid, [&](const SampleGrid& grid) {
      const DepthImage<float> image = z_buffer<float>(mesh, stripe.scene.view, grid);
      Image<Colour> colours(image.width, image.height, {255, 255, 255, 255});
      for (std::size_t k = 0; k < image.pixels.size(); ++k)
        if (image.pixels[k].triangle.is_valid()) colours.pixels[k] = stripe.colours[0];
      return colours;
    });
    CHECK(by_alpha == by_z);
    const auto grey = static_cast<std::uint8_t>((255 * (n - share) + n / 2) / n);
    CHECK(by_z.pixels == std::vector<Colour>{{0, 0, 0, 255}, {0, 0, 0, 255}, {grey, grey, grey, 255}, {255, 255, 255, 255}});
  }
  CHECK_THROWS_AS(supersampled(4, 1, 9, Stripe::grid, [](const SampleGrid&) { return Image<Colour>(); }), PreconditionError);
}

}  // namespace
}  // namespace hsr
