#include "study/depth_remedies.h"

#include <algorithm>
#include <array>

#include "geometry/mesh.h"
#include "hsr/raster/depth_buffer.h"

namespace hsr::internal {

namespace {

constexpr double distance = 100, far = 10000;

View view_along_z(double near) { return perspective_view({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, near); }

/// Samples on |x|, |y| < 1/2 of the plane z = -1.
SampleGrid grid() { return {{-0.4375, 0.4375, -1}, {0.0625, 0, 0}, {0, -0.0625, 0}, 15, 15}; }

/// Squares one behind the other, as large as their half width, whose distance is d + slope x; the first ones have the lower
/// index.
struct Square {
  double d, half, slope;
};

Mesh mesh_of(std::initializer_list<Square> squares) {
  std::vector<Point3> points;
  Polygons polygons;
  for (const Square& s : squares) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto corner = [&](double x, double y) { points.push_back({x, y, -(s.d + s.slope * x)}); };
    corner(-s.half, -s.half);
    corner(s.half, -s.half);
    corner(s.half, s.half);
    corner(-s.half, s.half);
    for (std::uint32_t k = 0; k < 4; ++k) polygons.corners.push_back(first + k);
    polygons.first.push_back(first + 4);
  }
  return make_mesh(points, polygons);
}

/// Whether all samples show the nearer wall, which is the second: its triangles are 2 and 3.
bool tells_apart(double z, double gap, double near, DepthFormat format) {
  const Mesh mesh = mesh_of({{z + gap, 2 * z, 0}, {z, 2 * z, 0}});
  const View view = view_along_z(near / 2);
  const DepthBuffer buffer = depth_buffer(mesh, view, grid(), depth_range(view, grid(), near, far), {.format = format});
  return std::all_of(buffer.triangles.pixels.begin(), buffer.triangles.pixels.end(),
                     [](TriangleId t) { return t.is_valid() && t.value >= 2; });
}

/// Halves the gap until it fails, at some of a few distances.
double measured_gap(double near, DepthFormat format) {
  double good = 0;
  for (double gap = distance / 2; gap > distance * 0x1p-60; gap /= 2) {
    for (int k = 0; k < 8; ++k)
      if (!tells_apart(distance * (1 + k / 64.0), gap, near, format)) return good;
    good = gap;
  }
  return good;
}

/// Of the samples of the decal, how many show it: 1, all.
double shown_share(double gap, const MeasuredBias& m) {
  constexpr double slope = 0.25, half = 32, near = 1;  // of corners that doubles have exactly
  const View view = view_along_z(near / 2);
  const DepthRange range = depth_range(view, grid(), near, far);
  const DepthBuffer wall = depth_buffer(mesh_of({{distance, 128, slope}}), view, grid(), range,
                                        {.format = m.format, .bias = m.bias, .slope_bias = m.slope_bias});
  const DepthBuffer decal = depth_buffer(mesh_of({{distance + gap, half, slope}}), view, grid(), range, {.format = m.format});
  std::size_t all = 0, shown = 0;
  for (std::size_t k = 0; k < decal.triangles.pixels.size(); ++k) {
    if (!decal.triangles.pixels[k].is_valid()) continue;
    ++all;
    shown += decal.depths.pixels[k] < wall.depths.pixels[k] ? 1U : 0U;
  }
  return static_cast<double>(shown) / static_cast<double>(all);
}

}  // namespace

std::vector<MeasuredGap> measured_gaps() {
  std::vector<MeasuredGap> rows;
  for (const double near : {0.1, 1.0, 10.0})
    for (const DepthFormat format : depth_formats)
      rows.push_back({format, distance, near, far, smallest_gap(format, distance, near, far), measured_gap(near, format)});
  return rows;
}

std::vector<MeasuredBias> measured_biases() {
  std::vector<MeasuredBias> rows;
  for (const DepthFormat format : {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::float32})
    for (const auto& [bias, slope_bias] : {std::array{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}) {
      MeasuredBias row{format, bias, slope_bias};
      row.shown_share = shown_share(0, row);
      for (double gap = distance / 2; gap > distance * 0x1p-60; gap /= 2)
        if (shown_share(gap, row) > 0) {
          row.shines_through = gap;
          break;
        }
      rows.push_back(row);
    }
  return rows;
}

}  // namespace hsr::internal
