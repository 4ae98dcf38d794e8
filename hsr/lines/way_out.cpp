#include "hsr/lines/way_out.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/vector3.h"

namespace hsr::internal {

namespace {

auto& coordinate(auto& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

double WayOut::norm_max(const Point3& p) { return internal::norm_max(p); }

WayOut::WayOut(const Mesh& mesh, int axis, bool forward, double slant)
    : mesh_(mesh), axis_(axis), sign_(forward ? 1 : -1), slope_{slant, 0.64 * slant} {
  double most = 0;
  for (const Point3& p : mesh.points) most = std::max(most, norm_max(p));
  // Products of numbers far below have no digits left: then nothing is certain.
  margin_ = rounding * most + 0x1p-900;
  std::vector<ImageBox> boxes(mesh.triangles.size(), ImageBox::nothing());
  parallel_for_each(boxes.size(), [&](std::size_t t) {
    for (const VertexId v : mesh.triangles[TriangleId(t)]) {
      const Seen p = seen(mesh.points[v]);
      boxes[t].add({p.u, p.v, p.along}, {margin_, margin_, margin_});
    }
  });
  tree_ = BoxTree(boxes);
}

WayOut::Seen WayOut::seen(const Point3& p) const {
  const double along = sign_ * coordinate(p, axis_);
  return {coordinate(p, (axis_ + 1) % 3) - slope_[0] * along, coordinate(p, (axis_ + 2) % 3) - slope_[1] * along, along};
}

Point3 WayOut::outside(const Point3& start, const Point3& low, const Point3& high) const {
  const double most = norm_max(minus(high, low));
  const double reach = sign_ > 0 ? std::max(0.0, coordinate(high, axis_) - coordinate(start, axis_)) + most
                                 : std::min(0.0, coordinate(low, axis_) - coordinate(start, axis_)) - most;
  Point3 end = start;
  coordinate(end, axis_) += reach;
  coordinate(end, (axis_ + 1) % 3) += slope_[0] * std::fabs(reach);
  coordinate(end, (axis_ + 2) % 3) += slope_[1] * std::fabs(reach);
  return end;
}

/// Each coordinate errs by less than the margin, and so does how far the way, which leads to a rounded point, is off.
WayOut::Crossing WayOut::crossing(TriangleId t, const Seen& from, double margin) const {
  std::array<Seen, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const Seen corner = seen(mesh_.points[mesh_.triangles[t][k]]);
    p[k] = {corner.u - from.u, corner.v - from.v, corner.along - from.along};
  }
  // Twice the areas that the start, as seen, makes with the sides.
  double sum = 0, error = 0, along = 0;
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Seen &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
    const double area = a.u * b.v - a.v * b.u;
    const double e = 8 * margin * (std::fabs(a.u) + std::fabs(a.v) + std::fabs(b.u) + std::fabs(b.v) + margin);
    if (area > e) ++left;
    if (area < -e) ++right;
    if (left > 0 && right > 0) return Crossing::no;
    sum += area;
    error += e;
    along += area * p[k].along;
  }
  if (left < 3 && right < 3) return Crossing::unknown;
  if (!(std::fabs(sum) > 2 * error)) return Crossing::unknown;
  along /= sum;
  const double far = std::fabs(p[0].along) + std::fabs(p[1].along) + std::fabs(p[2].along);
  const double slack = 8 * error / std::fabs(sum) * far + 8 * margin;
  return along > slack ? Crossing::yes : along < -slack ? Crossing::no : Crossing::unknown;
}

}  // namespace hsr::internal
