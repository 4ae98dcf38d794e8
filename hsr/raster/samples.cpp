#include "hsr/raster/samples.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/error.h"
#include "geometry/parallel_fold.h"
#include "geometry/vector3.h"

namespace hsr {

using namespace internal;

namespace {

/// The multiple of 2^power next to x. @pre |x| < 2^(power + 52)
double snapped(double x, int power) { return std::ldexp(std::round(std::ldexp(x, -power)), power) + 0.0; }
Point3 snapped(const Point3& p, int power) { return {snapped(p.x, power), snapped(p.y, power), snapped(p.z, power)}; }

}  // namespace

BitRange SampleGrid::bit_range() const {
  BitRange c;
  for (const Point3& p : {origin, right, down}) c.add(p);
  // Sums of at most 2^17 of each: no coordinate has more than 2^50 units, or the corners would show it.
  for (const int i : {0, width})
    for (const int j : {0, height}) {
      const Point3 p = at(i, j);
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "SampleGrid: samples are not finite");
      c.add(p);
    }
  require(c.bits() <= 51, "SampleGrid: samples are no doubles");
  return c;
}

SampleGrid sample_grid(const View& view, const PaperRectangle& part, int width, int height) {
  if (width < 1 || height < 1 || width > 65536 || height > 65536)
    throw InputError("samples: found " + std::to_string(width) + "x" + std::to_string(height) +
                     ", expected 1 to 65536 either way");
  const Frame& frame = view.frame;
  double pixel = std::max((part.right - part.left) / width, (part.top - part.bottom) / height);
  if (pixel == 0) pixel = 1;
  const Point3 middle =
      sum(sum(frame.origin, part.left / 2 + part.right / 2, frame.right), part.bottom / 2 + part.top / 2, frame.up);
  const double most = norm_max(middle) + (width + height) * pixel;
  if (!(pixel > 0 && most < 0x1p1020))
    throw InputError("samples: found a part of the paper that is not finite, expected a picture of one that is");
  // A step that is off by half a unit puts the farthest sample off by half the picture's units: a 16th of a pixel at most.
  // And the plane of the samples is off by less than 2^-20 from that of the paper.
  const int digits = std::max(std::ilogb(32.0 * std::max(width, height)) + 1, 21);
  int power = std::max(std::ilogb(pixel) - digits, std::ilogb(most) - 49);
  power = std::max(power, -1074);
  for (;; ++power) {
    pixel = std::max(pixel, std::ldexp(16.0, power));
    const Point3 right = snapped(sum({}, pixel, frame.right), power), down = snapped(sum({}, -pixel, frame.up), power);
    const Point3 corner = sum(sum(middle, -(width - 1) / 2.0 * pixel, frame.right), (height - 1) / 2.0 * pixel, frame.up);
    if (!(norm_max(corner) + width * norm_max(right) + height * norm_max(down) < std::ldexp(1.0, power + 50))) continue;
    return {snapped(corner, power), right, down, width, height};
  }
}

SampleGrid sample_grid(const View& view, const FrameSize& size, int width, int height) {
  return sample_grid(view, PaperRectangle{-size.half_width, size.half_width, -size.half_height, size.half_height}, width,
                     height);
}

/// With n the normal of the paper, toward the viewer: what is seen at p is at p itself, or at (p - e) (o - e).n / (p - e).n.
PaperRectangle paper_rectangle(const Mesh& mesh, const View& view) {
  const Frame& f = view.frame;
  const Point3 n = {f.right.y * f.up.z - f.right.z * f.up.y, f.right.z * f.up.x - f.right.x * f.up.z,
                    f.right.x * f.up.y - f.right.y * f.up.x};
  const Point3 &e = view.viewpoint.at, to_paper = sum(f.origin, -1, e), to_target = sum(view.target, -1, e);
  const auto add = [&](PaperRectangle& all, const Point3& p) {
    const Point3 from_origin = sum(p, -1, f.origin);
    Point3 at = from_origin;
    if (view.is_perspective()) {
      const Point3 to_p = sum(p, -1, e);
      at = sum(sum({}, dot(to_paper, n) / dot(to_p, n), to_p), -1, to_paper);
    }
    const double x = dot(at, f.right), y = dot(at, f.up);
    all = {std::min(all.left, x), std::max(all.right, x), std::min(all.bottom, y), std::max(all.top, y)};
  };
  // In the range of long doubles: lengths of 1e300 have squares.
  const auto beyond_near = [&](const Point3& p) {
    using Wide = long double;
    if (view.section) {
      const Point3 from = sum(p, -1, view.section->point), &normal = view.section->normal;
      return Wide(from.x) * normal.x + Wide(from.y) * normal.y + Wide(from.z) * normal.z;
    }
    const auto product = [&](const Point3& d) {
      return Wide(d.x) * to_target.x + Wide(d.y) * to_target.y + Wide(d.z) * to_target.z;
    };
    return product(sum(p, -1, e)) - view.near * product(to_target);
  };
  const PaperRectangle nothing = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  const PaperRectangle all = parallel_fold(
      mesh.edges.size(), nothing,
      [&](PaperRectangle& so_far, std::size_t i) {
        const Edge& edge = mesh.edges[EdgeId(i)];
        const Point3 &a = mesh.points[edge.a], &b = mesh.points[edge.b];
        const long double at_a = view.cuts() ? beyond_near(a) : 1, at_b = view.cuts() ? beyond_near(b) : 1;
        if (at_a > 0) add(so_far, a);
        if (at_b > 0) add(so_far, b);
        if ((at_a > 0) != (at_b > 0)) add(so_far, sum(a, static_cast<double>(at_a / (at_a - at_b)), sum(b, -1, a)));
      },
      [](PaperRectangle& so_far, const PaperRectangle& more) {
        so_far = {std::min(so_far.left, more.left), std::max(so_far.right, more.right), std::min(so_far.bottom, more.bottom),
                  std::max(so_far.top, more.top)};
      });
  return all.left <= all.right ? all : PaperRectangle{};
}

}  // namespace hsr
