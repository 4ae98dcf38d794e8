#include "hsr/raster/supersampling.h"

#include <array>
#include <cstdint>

#include "geometry/error.h"

namespace hsr::internal {

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

}  // namespace hsr::internal
