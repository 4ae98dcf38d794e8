#include "bench/peers/z_buffer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hsr::bench {

namespace {

/// The first pixel whose sample is at or after x, within 0 ... end. (x + 0.5 is above 0 after the clamp: the cast rounds down.)
int first_pixel(float x, int end) {
  const float k = std::clamp(x - 0.5F, 0.0F, static_cast<float>(end));
  const int whole = static_cast<int>(k);
  return whole + (static_cast<float>(whole) < k ? 1 : 0);
}

void draw_rows(ZBuffer& z, std::uint32_t triangle, const PixelPoint& from, const PixelPoint& to, float slope_from,
               float slope_to, int first, int last, const PixelPoint& corner, float step_x, float step_y) {
  for (int j = first; j < last; ++j) {
    const float y = static_cast<float>(j) + 0.5F;
    const int begin = first_pixel(from.x + (y - from.y) * slope_from, z.width);
    const int end = first_pixel(to.x + (y - to.y) * slope_to, z.width);
    Pixel* const row = z.pixels.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(z.width);
    float nearness = corner.nearness + (static_cast<float>(begin) + 0.5F - corner.x) * step_x + (y - corner.y) * step_y;
    for (int i = begin; i < end; ++i, nearness += step_x)
      if (nearness > row[i].nearness) row[i] = {nearness, triangle};
  }
}

void draw_triangle(ZBuffer& z, std::uint32_t triangle, PixelPoint a, PixelPoint b, PixelPoint c) {
  // Most triangles of a large mesh lie between the samples: leave early.
  const auto [low, high] = std::minmax({a.x, b.x, c.x});
  if (first_pixel(low, z.width) == first_pixel(high, z.width)) return;
  if (b.y < a.y) std::swap(a, b);
  if (c.y < a.y) std::swap(a, c);
  if (c.y < b.y) std::swap(b, c);
  const int top = first_pixel(a.y, z.height), bottom = first_pixel(c.y, z.height);
  if (top == bottom) return;
  const float bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const float area = bx * cy - by * cx;
  if (area == 0) return;
  const float bz = b.nearness - a.nearness, cz = c.nearness - a.nearness;
  const float step_x = (bz * cy - cz * by) / area, step_y = (cz * bx - bz * cx) / area;
  const int middle = first_pixel(b.y, z.height);
  const float long_side = cx / cy;
  // The long side ac is on the left where b is on the right of it.
  const bool b_on_right = area > 0;
  if (top < middle) {
    const float side = bx / by;
    if (b_on_right)
      draw_rows(z, triangle, a, a, long_side, side, top, middle, a, step_x, step_y);
    else
      draw_rows(z, triangle, a, a, side, long_side, top, middle, a, step_x, step_y);
  }
  if (middle < bottom) {
    const float side = (c.x - b.x) / (c.y - b.y);
    if (b_on_right)
      draw_rows(z, triangle, a, b, long_side, side, middle, bottom, a, step_x, step_y);
    else
      draw_rows(z, triangle, b, a, side, long_side, middle, bottom, a, step_x, step_y);
  }
}

}  // namespace

void ZBuffer::clear() { std::fill(pixels.begin(), pixels.end(), Pixel{}); }

void ZBuffer::draw(std::span<const PixelPoint> points, std::span<const std::array<VertexId, 3>> triangles) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    draw_triangle(*this, static_cast<std::uint32_t>(t), points[a.value], points[b.value], points[c.value]);
  }
}

}  // namespace hsr::bench
