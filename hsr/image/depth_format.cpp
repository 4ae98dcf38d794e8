#include "hsr/image/depth_format.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "hsr/image/projection.h"

namespace hsr {

std::string_view name(DepthFormat format) {
  switch (format) {
    case DepthFormat::fixed8:
      return "fixed 8";
    case DepthFormat::fixed16:
      return "fixed 16";
    case DepthFormat::fixed24:
      return "fixed 24";
    case DepthFormat::fixed32:
      return "fixed 32";
    case DepthFormat::float32:
      return "float 32";
    case DepthFormat::float64:
      return "float 64";
    case DepthFormat::reversed_float32:
      return "float 32 reversed";
    case DepthFormat::logarithmic_float32:
      return "float 32 logarithmic";
  }
  return "";
}

int fixed_bits(DepthFormat format) {
  switch (format) {
    case DepthFormat::fixed8:
      return 8;
    case DepthFormat::fixed16:
      return 16;
    case DepthFormat::fixed24:
      return 24;
    case DepthFormat::fixed32:
      return 32;
    default:
      return 0;
  }
}

DepthRange depth_range(const Mesh& mesh, const View& view, const SampleGrid& samples) {
  const Projection<double> project(view, samples);
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto add = [&](double nearness) {
    if (!std::isfinite(nearness)) return;
    low = std::min(low, nearness);
    high = std::max(high, nearness);
  };
  bool is_cut = false;
  for (const auto& triangle : mesh.triangles)
    for (const VertexId v : triangle) {
      if (view.is_perspective() && is_before_near(view, mesh.points[v]))
        is_cut = true;
      else
        add(project(mesh.points[v]).nearness);
    }
  if (is_cut) add(1 / view.near - 1);  // the near plane itself
  if (!(low <= high)) return {1, 0, view.is_perspective()};
  // Room for rounding; where all is at one depth, as much as its numbers need.
  const double room = std::max((high - low) / 1024, 0x1p-20 * std::max({std::fabs(high), std::fabs(low), 0x1p-900}));
  DepthRange range{high + room, low - room, view.is_perspective()};
  // Farther than any distance there is none.
  if (range.is_perspective) range.far = std::max(range.far, (low + 1) / 2 - 1);
  return range;
}

DepthRange depth_range(const View& view, const SampleGrid& samples, double near, double far) {
  if (!view.is_perspective()) throw InputError("near, far: found a parallel view, expected a perspective");
  if (!(near > 0 && near < far && std::isfinite(far))) throw InputError("near, far: expected 0 < near < far");
  const Projection<double> project(view, samples);
  const Point3 &e = view.viewpoint.at, &t = view.target;
  const double x = t.x - e.x, y = t.y - e.y, z = t.z - e.z, length = std::hypot(x, y, z);
  const auto nearness = [&](double distance) {
    const double k = distance / length;
    return project(Point3{e.x + k * x, e.y + k * y, e.z + k * z}).nearness;
  };
  return {nearness(near), nearness(far), true};
}

double transformed_depth(double z, double near, double far) {
  const double c = -near / far;
  return (c - z) / (z + z * c);
}

double smallest_gap(DepthFormat format, double z, double near, double far) {
  // d = f (z - n) / (z (f - n)); dd/dz = n f / (z^2 (f - n))
  const double slope = near * far / (z * z * (far - near));
  const double depth = far * (z - near) / (z * (far - near));
  const auto step_of = [](double x, double epsilon) { return std::ldexp(epsilon, std::ilogb(std::max(x, 0x1p-1000))); };
  constexpr double single = std::numeric_limits<float>::epsilon(), twice = std::numeric_limits<double>::epsilon();
  switch (format) {
    case DepthFormat::float32:
      return step_of(depth, single) / slope;
    case DepthFormat::float64:
      return step_of(depth, twice) / slope;
    case DepthFormat::reversed_float32:
      return step_of(1 - depth, single) / slope;
    case DepthFormat::logarithmic_float32: {
      const double all = std::log(far / near);
      return step_of(std::log(z / near) / all, single) * all * z;
    }
    default:
      return 1 / (std::ldexp(1.0, fixed_bits(format)) - 1) / slope;
  }
}

}  // namespace hsr
