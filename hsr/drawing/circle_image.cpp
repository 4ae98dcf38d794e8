#include "hsr/drawing/circle_image.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace hsr::internal {

namespace {

constexpr double rounding = 0.001;  // mm: two coordinates that are rounded to it are off by 0.0007 at most

double dot(const std::array<double, 4>& row, const SpaceVector& p) { return row[0] * p[0] + row[1] * p[1] + row[2] * p[2]; }

/// The ellipse with these two conjugate half diameters: the images of two half diameters of a circle that are at right angles.
EllipseArc with_diameters(const Point2& centre, const Point2& p, const Point2& q) {
  const double t = std::atan2(2 * (p.x * q.x + p.y * q.y), p.x * p.x + p.y * p.y - q.x * q.x - q.y * q.y) / 2;
  const double c = std::cos(t), s = std::sin(t);
  EllipseArc arc;
  arc.centre = centre;
  arc.to = 2 * std::numbers::pi;
  arc.long_axis = {c * p.x + s * q.x, c * p.y + s * q.y};
  const Point2 other = {c * q.x - s * p.x, c * q.y - s * p.y};
  const double radius = arc.long_radius(), short_radius = std::hypot(other.x, other.y);
  if (radius - short_radius <= rounding) {
    const double mean = (radius + short_radius) / 2;
    arc.long_axis = {mean, 0};
    arc.short_axis = {0, mean};
  } else {
    arc.short_axis = {-arc.long_axis.y * short_radius / radius, arc.long_axis.x * short_radius / radius};
  }
  return arc;
}

}  // namespace

PaperMap::PaperMap(const Projection& projection) : anchor_(projection.anchor()), rows_(projection.rounded_rows()) {}

SpaceVector PaperMap::relative(const Point3& p) const { return {p.x - anchor_.x, p.y - anchor_.y, p.z - anchor_.z}; }

Point2 PaperMap::at(const SpaceVector& p) const {
  const double w = dot(rows_[2], p) + rows_[2][3];
  return {(dot(rows_[0], p) + rows_[0][3]) / w, (dot(rows_[1], p) + rows_[1][3]) / w};
}

double PaperMap::magnification(const SpaceVector& p) const {
  const Point2 image = at(p);
  const double w = dot(rows_[2], p) + rows_[2][3];
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = (rows_[0][k] - image.x * rows_[2][k]) / w, y = (rows_[1][k] - image.y * rows_[2][k]) / w;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  return std::sqrt((xx + yy) / 2 + std::hypot((xx - yy) / 2, xy));
}

// With h = (x, y, w) of u, v and the centre, a point of the circle is seen at x / w, y / w of cos t h_u + sin t h_v + h_c. Turned so
// that w does not depend on sin t, w is w_c (1 + g cos t). Moving t along as a boost moves the directions of light keeps the circle
// and makes w constant: c' = (c + g) / (1 + g c), s' = s r / (1 + g c) with r = sqrt(1 - g g). What is left is affine.
std::optional<EllipseArc> PaperMap::image(const SpaceCircle& circle) const {
  std::array<std::array<double, 3>, 3> h;  // of u, v and the centre
  for (std::size_t i = 0; i < 3; ++i) {
    h[0][i] = circle.radius * dot(rows_[i], circle.u);
    h[1][i] = circle.radius * dot(rows_[i], circle.v);
    h[2][i] = dot(rows_[i], circle.centre) + rows_[i][3];
  }
  const double w = h[2][2], g = std::hypot(h[0][2], h[1][2]) / w;
  if (!(w > 0) || !(g < 1)) return {};
  const double turn = std::atan2(h[1][2], h[0][2]), c = std::cos(turn), s = std::sin(turn), r = std::sqrt(1 - g * g);
  std::array<Point2, 3> affine;  // of cos t', sin t' and 1
  for (const auto axis : {std::size_t{0}, std::size_t{1}}) {
    const double u = c * h[0][axis] + s * h[1][axis], v = c * h[1][axis] - s * h[0][axis];
    const double of_cosine = (u - g * h[2][axis]) / (w * r * r), of_sine = v / (w * r),
                 of_one = (h[2][axis] - g * u) / (w * r * r);
    (axis == 0 ? affine[0].x : affine[0].y) = of_cosine;
    (axis == 0 ? affine[1].x : affine[1].y) = of_sine;
    (axis == 0 ? affine[2].x : affine[2].y) = of_one;
  }
  const EllipseArc ellipse = with_diameters(affine[2], affine[0], affine[1]);
  constexpr double thinnest = 0.01;  // mm: what is thinner is seen as a line
  if (!(ellipse.short_radius() >= thinnest) || !std::isfinite(ellipse.long_radius())) return {};
  return ellipse;
}

bool passes_through(const EllipseArc& ellipse, const Point2& p) {
  const Point2 on = ellipse.at(ellipse.parameter_of(p));
  return std::hypot(on.x - p.x, on.y - p.y) <= rounding;
}

std::optional<EllipseArc> through_ends(const EllipseArc& ellipse, std::span<const Point2> points) {
  // Where the ellipse is the unit circle, the centre is on the line at right angles to the chord, t from its middle m: for a point x,
  // |x - c|^2 - |a - c|^2 is linear in t.
  const double long_square = std::pow(ellipse.long_radius(), 2), short_square = std::pow(ellipse.short_radius(), 2);
  const auto round = [&](const Point2& p) {
    const double x = p.x - ellipse.centre.x, y = p.y - ellipse.centre.y;
    return Point2{(x * ellipse.long_axis.x + y * ellipse.long_axis.y) / long_square,
                  (x * ellipse.short_axis.x + y * ellipse.short_axis.y) / short_square};
  };
  const Point2 a = round(points.front()), b = round(points.back());
  const Point2 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2}, across = {a.y - b.y, b.x - a.x};
  if (across.x == 0 && across.y == 0) return {};
  double products = 0, squares = 0;
  for (const Point2& p : points.subspan(1, points.size() - 2)) {
    const Point2 x = round(p), d = {x.x - a.x, x.y - a.y};
    const double rest = x.x * x.x + x.y * x.y - a.x * a.x - a.y * a.y - 2 * (middle.x * d.x + middle.y * d.y);
    const double slope = 2 * (across.x * d.x + across.y * d.y);
    products += rest * slope;
    squares += slope * slope;
  }
  const double t = products / squares;
  const Point2 centre = {middle.x + t * across.x, middle.y + t * across.y};
  const double radius = std::hypot(a.x - centre.x, a.y - centre.y);
  if (!std::isfinite(radius)) return {};
  EllipseArc moved = ellipse;
  moved.centre = {ellipse.centre.x + centre.x * ellipse.long_axis.x + centre.y * ellipse.short_axis.x,
                  ellipse.centre.y + centre.x * ellipse.long_axis.y + centre.y * ellipse.short_axis.y};
  for (Point2* const axis : {&moved.long_axis, &moved.short_axis}) *axis = {axis->x * radius, axis->y * radius};
  return moved;
}

}  // namespace hsr::internal
