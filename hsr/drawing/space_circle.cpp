#include "hsr/drawing/space_circle.h"

#include <cmath>

namespace hsr::internal {

namespace {

SpaceVector minus(const SpaceVector& a, const SpaceVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const SpaceVector& a, const SpaceVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
SpaceVector cross(const SpaceVector& a, const SpaceVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
SpaceVector scaled(const SpaceVector& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
SpaceVector plus(const SpaceVector& a, const SpaceVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

std::optional<SpaceVector> unit(const SpaceVector& a) {
  const double length = std::sqrt(dot(a, a));
  if (!(length > 0) || !std::isfinite(length)) return {};
  return scaled(a, 1 / length);
}

}  // namespace

double SpaceCircle::distance(const SpaceVector& p) const {
  const SpaceVector d = minus(p, centre);
  return std::hypot(std::hypot(dot(d, u), dot(d, v)) - radius, dot(d, cross(u, v)));
}

double SpaceCircle::angle(const SpaceVector& p) const {
  const SpaceVector d = minus(p, centre);
  return std::atan2(dot(d, v), dot(d, u));
}

bool are_one(const SpaceCircle& c, const SpaceCircle& d) {
  constexpr double share = 1e-6;
  const SpaceVector apart = minus(c.centre, d.centre), turned = minus(cross(c.u, c.v), cross(d.u, d.v));
  return std::fabs(c.radius - d.radius) <= share * c.radius && std::sqrt(dot(apart, apart)) <= share * c.radius &&
         std::sqrt(dot(turned, turned)) <= share;
}

std::optional<SpaceCircle> circle_around(const SpaceVector& centre, const SpaceVector& axis, double radius,
                                         const SpaceVector& from, const SpaceVector& to) {
  const SpaceVector out = minus(from, centre);
  const auto u = unit(minus(out, scaled(axis, dot(out, axis))));
  if (!u) return {};
  const SpaceVector ahead = cross(axis, *u);
  const double turn = dot(minus(to, centre), ahead);
  if (turn == 0) return {};
  return SpaceCircle{centre, *u, scaled(ahead, turn > 0 ? 1 : -1), radius};
}

std::optional<SpaceCircle> circle_through(std::span<const SpaceVector> points) {
  SpaceVector sum = {}, middle = {};
  for (std::size_t k = 0; k < points.size(); ++k) {
    middle = plus(middle, minus(points[k], points[0]));
    if (k + 1 < points.size()) sum = plus(sum, cross(minus(points[k], points[0]), minus(points[k + 1], points[0])));
  }
  const auto n = static_cast<double>(points.size());
  middle = plus(points[0], scaled(middle, 1 / n));
  const auto normal = unit(sum);
  if (!normal) return {};
  const SpaceVector out = minus(points[0], middle);
  const auto u = unit(minus(out, scaled(*normal, dot(out, *normal))));
  if (!u) return {};
  SpaceCircle circle;
  circle.u = *u;
  circle.v = cross(*normal, *u);
  double xx = 0, xy = 0, yy = 0, right_x = 0, right_y = 0;
  for (const SpaceVector& p : points) {
    const double x = dot(minus(p, middle), circle.u), y = dot(minus(p, middle), circle.v), square = x * x + y * y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    right_x += x * square / 2;
    right_y += y * square / 2;
  }
  const double determinant = xx * yy - xy * xy;
  const double x = (right_x * yy - right_y * xy) / determinant, y = (right_y * xx - right_x * xy) / determinant;
  circle.centre = plus(middle, plus(scaled(circle.u, x), scaled(circle.v, y)));
  circle.radius = std::sqrt(x * x + y * y + (xx + yy) / n);
  if (!std::isfinite(circle.radius)) return {};
  return circle;
}

}  // namespace hsr::internal
