#include "tests/raster/aligned_grids.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace hsr {

namespace {

constexpr int width = 16, height = 12;

/// Samples through the image of a, with b half the picture away: on a plane parallel to two axes that the viewpoint is not in.
/// @return whether there is such a grid, exactly
bool through(const Mesh& mesh, const View& view, VertexId a, double step, SampleGrid& grid) {
  const Point3& d = view.viewpoint.at;
  const Point3& p = mesh.points[a];
  const Point3 along = view.is_perspective() ? Point3{view.target.x - d.x, view.target.y - d.y, view.target.z - d.z} : d;
  const double x = std::fabs(along.x), y = std::fabs(along.y), z = std::fabs(along.z);
  Point3 right, down;
  if (z >= x && z >= y) {
    right = {step, 0, 0}, down = {0, -step, 0};
  } else if (y >= x) {
    right = {step, 0, 0}, down = {0, 0, -step};
  } else {
    right = {0, step, 0}, down = {0, 0, -step};
  }
  grid = {{p.x - 7 * right.x - 5 * down.x, p.y - 7 * right.y - 5 * down.y, p.z - 7 * right.z - 5 * down.z},
          right,
          down,
          width,
          height};
  if (!(grid.at(7, 5) == p)) return false;
  try {
    return grid.bit_range().bits() > 0;
  } catch (const PreconditionError&) {
    return false;
  }
}

}  // namespace

std::vector<SampleGrid> aligned_grids(const Mesh& mesh, const View& view) {
  std::vector<SampleGrid> grids;
  try {
    grids.push_back(sample_grid(view, paper_rectangle(mesh, view), width, height));
  } catch (const InputError&) {
    // Beyond the range of doubles.
  }
  if (mesh.edges.empty()) return grids;
  for (const EdgeId e : {EdgeId(0), EdgeId(mesh.edges.size() / 2), EdgeId(mesh.edges.size() - 1)}) {
    const Point3 &a = mesh.points[mesh.edges[e].a], &b = mesh.points[mesh.edges[e].b];
    const double size = std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
    if (!(size > 0 && size < 0x1p1000)) continue;
    SampleGrid grid;
    for (const double part : {1.0, 0.5, 0.125})
      if (through(mesh, view, mesh.edges[e].a, size * part, grid)) grids.push_back(grid);
  }
  return grids;
}

}  // namespace hsr
