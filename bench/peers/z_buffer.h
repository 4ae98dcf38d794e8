#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::bench {

/// A point in pixels: pixel (i, j) has its sample at (i + 0.5, j + 0.5). Larger is nearer.
struct PixelPoint {
  float x = 0, y = 0, nearness = 0;
};

struct Pixel {
  float nearness = -std::numeric_limits<float>::infinity();
  std::uint32_t triangle = 0xffffffffU;  ///< none
};

/// The plain float z-buffer, the image-space yardstick: each triangle is drawn by scanlines, depth goes up by a constant from
/// pixel to pixel; no division per pixel in parallel and perspective views alike (nearness is flat in the image). One thread,
/// no vector instructions by hand.
///
///   (1) a pixel has the triangle nearest at its sample, as exactly as floats tell; of equally near ones the lowest index
///   (2) a sample on an edge belongs to the triangle on its right, or below it: triangles that share an edge leave no gap and
///       share no pixel
struct ZBuffer {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;  ///< rows from y = 0

  ZBuffer(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  void clear();
  void draw(std::span<const PixelPoint> points, std::span<const std::array<VertexId, 3>> triangles);
  const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

}  // namespace hsr::bench
