#include "study/depth_remedies.h"

#include <algorithm>
#include <array>

#include "geometry/mesh.h"
#include "hsr/raster/depth_buffer.h"
#include "study/opengl_buffer.h"

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

/// Whether all samples show the nearer wall, which is the second: its triangles are 2 and 3. @param gl draws; null: we do
bool tells_apart(double z, double gap, double near, DepthFormat format, OpenGl* gl) {
  const Mesh mesh = mesh_of({{z + gap, 2 * z, 0}, {z, 2 * z, 0}});
  const View view = view_along_z(near / 2);
  const DepthRange range = depth_range(view, grid(), near, far);
  const Image<TriangleId> shown = gl != nullptr ? gl->draw(mesh, view, grid(), range, {.format = format})
                                                : depth_buffer(mesh, view, grid(), range, {.format = format}).triangles;
  return std::all_of(shown.pixels.begin(), shown.pixels.end(), [](TriangleId t) { return t.is_valid() && t.value >= 2; });
}

/// Halves the gap until it fails, at some of a few distances.
double measured_gap(double near, DepthFormat format, OpenGl* gl) {
  double good = 0;
  for (double gap = distance / 2; gap > distance * 0x1p-60; gap /= 2) {
    for (int k = 0; k < 8; ++k)
      if (!tells_apart(distance * (1 + k / 64.0), gap, near, format, gl)) return good;
    good = gap;
  }
  return good;
}

constexpr double slope = 0.25, half = 32;  // of corners that doubles have exactly

/// Of the samples of the decal, how many show it: 1, all. The decal comes after the wall, of equal depths the wall stays; as is the custom
/// with drivers it is the decal that is moved, toward the eye.
double shown_share(double gap, const MeasuredBias& m, OpenGl& gl) {
  constexpr double near = 1;
  const View view = view_along_z(near / 2);
  const DepthRange range = depth_range(view, grid(), near, far);
  const Square square{distance + gap, half, slope};
  const Image<TriangleId> decal = gl.draw(mesh_of({square}), view, grid(), range, {.format = m.format});
  const Image<TriangleId> both = gl.draw(mesh_of({{distance, 128, slope}, square}), view, grid(), range,
                                         {.format = m.format,
                                          .offset_factor = -static_cast<float>(m.slope_bias),
                                          .offset_units = -static_cast<float>(m.bias),
                                          .offset_from = 2});
  std::size_t all = 0, shown = 0;
  for (std::size_t k = 0; k < decal.pixels.size(); ++k) {
    if (!decal.pixels[k].is_valid()) continue;
    ++all;
    shown += both.pixels[k].is_valid() && both.pixels[k].value >= 2 ? 1U : 0U;
  }
  return static_cast<double>(shown) / static_cast<double>(all);
}

double shown_share(double gap, const MeasuredBias& m, OpenGl* gl) {
  if (gl != nullptr) return shown_share(gap, m, *gl);
  constexpr double near = 1;
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
  const auto add = [&](double near, DepthFormat format, const std::string& drawn_by, OpenGl* gl) {
    rows.push_back(
        {drawn_by, format, distance, near, far, smallest_gap(format, distance, near, far), measured_gap(near, format, gl)});
  };
  for (const double near : {0.1, 1.0, 10.0}) {
    for (const DepthFormat format : depth_formats) add(near, format, "hsr", nullptr);
    if (OpenGl* const gl = opengl_driver())
      for (const DepthFormat format : opengl_formats) add(near, format, "OpenGL, " + gl->driver(), gl);
  }
  return rows;
}

std::vector<MeasuredBias> measured_biases() {
  std::vector<MeasuredBias> rows;
  const auto add = [&](const std::string& drawn_by, OpenGl* gl) {
    for (const DepthFormat format : {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::float32})
      for (const auto& [bias, slope_bias] : {std::array{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}) {
        MeasuredBias row{drawn_by, format, bias, slope_bias};
        row.shown_share = shown_share(0, row, gl);
        for (double gap = distance / 2; gap > distance * 0x1p-60; gap /= 2)
          if (shown_share(gap, row, gl) > 0) {
            row.shines_through = gap;
            break;
          }
        rows.push_back(row);
      }
  };
  add("hsr", nullptr);
  if (OpenGl* const gl = opengl_driver()) add("OpenGL, " + gl->driver(), gl);
  return rows;
}

}  // namespace hsr::internal
