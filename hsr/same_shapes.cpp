#include "hsr/same_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/disjoint_sets.h"
#include "geometry/vector3.h"
#include "hsr/face_labels.h"

namespace hsr::internal {

namespace {

/// What a shape is known by, whatever point and direction of its axis a surface names.
using Traits = std::array<double, 8>;

/// Of length 1, and the first coordinate that is clearly not 0 positive.
Point3 unsigned_direction(const Point3& d) {
  for (const double x : {d.x, d.y, d.z}) {
    if (std::fabs(x) < 1e-3) continue;
    return x > 0 ? d : Point3{-d.x, -d.y, -d.z};
  }
  return d;
}

/// @param size lengths are in units of it
std::optional<Traits> traits_of(const KnownSurface& s, double size) {
  const Point3 d = unsigned_direction(s.direction);
  const double along = dot(s.point, d);
  const auto kind = static_cast<double>(s.kind);
  if (s.kind == SurfaceKind::plane) return Traits{kind, d.x, d.y, d.z, along / size};
  if (s.kind == SurfaceKind::sphere) return Traits{kind, s.point.x / size, s.point.y / size, s.point.z / size, s.radius / size};
  if (s.kind != SurfaceKind::cylinder) return std::nullopt;
  const Point3 foot = sum(s.point, -along, d);  // of the axis, nearest to the origin
  return Traits{kind, d.x, d.y, d.z, foot.x / size, foot.y / size, foot.z / size, s.radius / size};
}

double size_of(const Model& model) {
  double size = 0;
  for (const Point3& p : model.points) size = std::max(size, norm_max(p));
  return size > 0 ? size : 1;
}

}  // namespace

std::vector<std::uint32_t> shapes_of(const Model& model) {
  if (model.face_surface.empty()) return {};
  constexpr double cell = 1e-7;
  const double size = size_of(model);
  DisjointSets same(model.surfaces.size());
  // What is nearly alike may be in two cells of one grid, and is in one of the other, half a cell beside it.
  for (const double shift : {0.0, 0.5}) {
    std::map<std::array<double, 8>, std::uint32_t> first;
    for (std::uint32_t k = 0; k < model.surfaces.size(); ++k) {
      const auto traits = traits_of(model.surfaces[k], size);
      if (!traits) continue;
      std::array<double, 8> at;
      std::transform(traits->begin(), traits->end(), at.begin(), [&](double x) { return std::round(x / cell + shift) + 0.0; });
      same.join(k, first.try_emplace(at, k).first->second);
    }
  }
  std::vector<std::uint32_t> shapes;
  shapes.reserve(model.face_surface.size());
  for (const std::uint32_t s : model.face_surface) shapes.push_back(s < same.size() ? same.find(s) : s);
  return shapes;
}

}  // namespace hsr::internal
