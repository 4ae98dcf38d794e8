#include "hsr/raster/depth_format.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

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
  const SampleProjection<double> project(view, samples);
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto add = [&](double nearness) {
    if (!std::isfinite(nearness)) return;
    low = std::min(low, nearness);
    high = std::max(high, nearness);
  };
  bool is_cut = false;
  for (const auto& triangle : mesh.triangles)
    for (const VertexId v : triangle) {
      const bool is_before = view.cuts() && is_before_near(view, mesh.points[v]);
      is_cut = is_cut || is_before;
      // Where a section cuts is somewhere between what it leaves and what it takes.
      if (!is_before || view.section) add(project(mesh.points[v]).nearness);
    }
  if (is_cut && !view.section) add(1 / view.near - 1);  // the near plane itself
  if (!(low <= high)) return {1, 0, view.is_perspective()};
  // Room for rounding: with 8 bits, too, the farthest must not get the depth that all begins at. Where all is at one depth, as
  // much as its numbers need.
  const double room = std::max((high - low) / 128, 0x1p-20 * std::max({std::fabs(high), std::fabs(low), 0x1p-900}));
  DepthRange range{high + room, low - room, view.is_perspective()};
  // Farther than any distance there is none.
  if (range.is_perspective) range.far = std::max(range.far, (low + 1) / 2 - 1);
  return range;
}

DepthRange depth_range(const View& view, const SampleGrid& samples, double near, double far) {
  if (!view.is_perspective()) throw InputError("near, far: found a parallel view, expected a perspective");
  if (!(near > 0 && near < far && std::isfinite(far))) throw InputError("near, far: expected 0 < near < far");
  const SampleProjection<double> project(view, samples);
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

namespace {

constexpr double single = std::numeric_limits<float>::epsilon(), twice = std::numeric_limits<double>::epsilon();

/// Between a floating-point number and the next.
double step_of(double x, double epsilon) { return std::ldexp(epsilon, std::ilogb(std::max(std::fabs(x), 0x1p-1000))); }

}  // namespace

double step(DepthFormat format, const DepthRange& range, double nearness) {
  const double all = range.near - range.far, depth = range.depth(nearness);
  switch (format) {
    case DepthFormat::float32:
      return step_of(depth, single) * all;
    case DepthFormat::float64:
      return step_of(depth, twice) * all;
    case DepthFormat::reversed_float32:
      return step_of((nearness - range.far) / all, single) * all;
    case DepthFormat::logarithmic_float32: {
      const double log_range = std::log((range.near + 1) / (range.far + 1)), inverse = nearness + 1;
      // So far away that no double tells the distance from infinity: nothing is told apart.
      if (!(inverse > 0 && std::isfinite(log_range))) return HUGE_VAL;
      return step_of(std::log((range.near + 1) / inverse) / log_range, single) * log_range * inverse;
    }
    default:
      return all / (std::ldexp(1.0, fixed_bits(format)) - 1);
  }
}

double smallest_gap(DepthFormat format, double z, double near, double far) {
  // In units of z the nearness is 1 / z - 1: it changes by 1 / z^2.
  return step(format, {1 / near - 1, 1 / far - 1, true}, 1 / z - 1) * z * z;
}

}  // namespace hsr::internal
