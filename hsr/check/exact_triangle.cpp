#include "hsr/check/exact_triangle.h"

#include <algorithm>
#include <cmath>

namespace hsr::internal {

namespace {

ErrorBounded rounded(const Rational& x) {
  const double v = x.to_double();
  return {v, ErrorBounded::u * std::fabs(v) + ErrorBounded::lost};
}

Rational twice_area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

ImageFunction::ImageFunction(Rational origin, Rational right, Rational down)
    : exact_{std::move(origin), std::move(right), std::move(down)},
      rounded_{rounded(exact_[0]), rounded(exact_[1]), rounded(exact_[2])} {}

Sign ImageFunction::sign(int i, int j) const {
  const ErrorBounded x = near(i, j);
  if (x.is_certain()) return sign_of(x.value);
  if (const Sign s = at(i, j).sign(); s != Sign::zero) return s;
  const Sign right = exact_[1].sign();
  return right != Sign::zero ? right : exact_[2].sign();
}

ImageFunction line(const ExactPoint& p, const ExactPoint& q) {
  const Rational dx = q.x - p.x, dy = q.y - p.y;
  return {dy * p.x - dx * p.y, -dy, dx};
}

bool ExactTriangle::covers(int i, int j) const {
  return has_area && std::all_of(sides.begin(), sides.end(), [&](const auto& s) { return s.sign(i, j) == Sign::positive; });
}

Sign compared(const ImageFunction& a, const ImageFunction& b, int i, int j, double bound) {
  const ErrorBounded d = a.near(i, j) - b.near(i, j);
  if (d.value - d.error > bound) return Sign::positive;
  if (d.value + d.error < -bound) return Sign::negative;
  if (std::fabs(d.value) + d.error < bound) return Sign::zero;
  if (!std::isfinite(bound)) return Sign::zero;
  const Rational exact = a.at(i, j) - b.at(i, j);
  return exact > Rational(bound) ? Sign::positive : exact < Rational(-bound) ? Sign::negative : Sign::zero;
}

ExactTriangle ExactTriangles::operator()(TriangleId t) const {
  std::array<ExactPoint, 4> exact;
  const int count = seen_corners<Rational>(
      mesh_, view_, project_, t, [&](VertexId v) { return is_cut_away(v); },
      [&](VertexId v) { return project_(mesh_.points[v]); }, exact);
  ExactTriangle result;
  result.corners.assign(exact.begin(), exact.begin() + count);
  const auto& c = result.corners;
  for (std::size_t k = 2; k < c.size() && !result.has_area; ++k) {
    const Rational area = twice_area(c[0], c[k - 1], c[k]);
    if (area.sign() == Sign::zero) continue;
    result.has_area = true;
    const Rational x1 = c[k - 1].x - c[0].x, y1 = c[k - 1].y - c[0].y, z1 = c[k - 1].nearness - c[0].nearness;
    const Rational x2 = c[k].x - c[0].x, y2 = c[k].y - c[0].y, z2 = c[k].nearness - c[0].nearness;
    const Rational along_x = (z1 * y2 - z2 * y1) / area, along_y = (z2 * x1 - z1 * x2) / area;
    result.nearness = {c[0].nearness - along_x * c[0].x - along_y * c[0].y, along_x, along_y};
    for (std::size_t m = 0; m < c.size(); ++m) {
      const ExactPoint &p = c[m], &q = c[(m + 1) % c.size()];
      if (p.x == q.x && p.y == q.y) continue;
      result.sides.push_back(area.sign() == Sign::positive ? line(p, q) : line(q, p));
    }
  }
  return result;
}

}  // namespace hsr::internal
