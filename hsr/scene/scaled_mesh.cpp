#include "hsr/scene/scaled_mesh.h"

#include <cmath>

#include "geometry/parallel.h"

namespace hsr::internal {

int scale_of(const BitRange& c) { return c.is_zero() || c.lowest - c.highest < -1000 ? 0 : -c.highest; }

Point3 scaled(const Point3& p, int power) {
  return {std::ldexp(p.x, power) + 0.0, std::ldexp(p.y, power) + 0.0, std::ldexp(p.z, power) + 0.0};
}

BitRange scaled(const BitRange& c, int power) { return c.is_zero() ? c : BitRange{c.lowest + power, c.highest + power}; }

ScaledMesh::ScaledMesh(const Mesh& mesh) : mesh_(&mesh), points_(mesh.points.size()) {
  // Only of the points that are used: a stray one far away must not cost the others the fast arithmetic.
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  for (const Edge& e : mesh.edges) is_used[e.a.value] = is_used[e.b.value] = 1;
  BitRange given;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (is_used[i] != 0) given.add(mesh.points[VertexId(i)]);
  const int power = scale_of(given);
  bit_range_ = scaled(given, power);
  parallel_for_each(is_used.size(), [&](std::size_t i) {
    if (is_used[i] != 0) points_[VertexId(i)] = scaled(mesh.points[VertexId(i)], power);
  });
  filter_arithmetic_ = predicates().filter_is_proven() ? Arithmetic::staged : Arithmetic::interval;
}

}  // namespace hsr::internal
