#include "geometry/view_plane.h"

#include <cmath>

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/rational_arithmetic.h"
#include "geometry/view_plane_polynomials.h"

namespace hsr {

namespace {

using Vector = polynomials::Vector<ErrorBounded>;

ErrorBounded dot(const Point3& row, const Vector& q) {
  return ErrorBounded{row.x, 0} * q.x + ErrorBounded{row.y, 0} * q.y + ErrorBounded{row.z, 0} * q.z;
}

std::array<ErrorBounded, 2> image_of_ray(const Camera& camera, const Vector& q, const std::array<Point3, 2>& rows) {
  const FilterArithmetic a;
  const auto axis = polynomials::difference(a, camera.target, camera.eye.at);
  const ErrorBounded depth = polynomials::dot(axis, q);
  return {quotient(dot(rows[0], q), depth), quotient(dot(rows[1], q), depth)};
}

}  // namespace

int largest_axis(const Point3& d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

std::array<ErrorBounded, 2> image_of_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m,
                                              const Point3& origin, const std::array<Point3, 2>& rows) {
  const FilterArithmetic a;
  const auto q = polynomials::cross(polynomials::line(a, camera, l, origin), polynomials::line(a, camera, m, origin));
  if (!camera.eye.is_direction) return image_of_ray(camera, q, rows);
  return {quotient(q.x, q.z), quotient(q.y, q.z)};
}

std::array<ErrorBounded, 2> image_of_point(const Camera& camera, const Point3& p, const Point3& origin,
                                           const std::array<Point3, 2>& rows) {
  const FilterArithmetic a;
  if (camera.eye.is_direction) {
    const Point3& d = camera.eye.at;
    const int k = largest_axis(d), i = (k + 1) % 3, j = (k + 2) % 3;
    const auto share = [&](int axis) {
      return a.difference(p, origin, axis) - quotient({d[axis], 0}, {d[k], 0}) * a.difference(p, origin, k);
    };
    return {share(i), share(j)};
  }
  return image_of_ray(camera, polynomials::difference(a, p, camera.eye.at), rows);
}

namespace {

using Exact = polynomials::Vector<Rational>;

/// A point of the line of sight with the direction of the ray, or the homogeneous coordinates, q.
Exact point_of_ray(const Camera& camera, const Exact& q, const Point3& origin) {
  if (!camera.eye.is_direction) {
    const Point3& e = camera.eye.at;
    return {Rational(e.x) + q.x, Rational(e.y) + q.y, Rational(e.z) + q.z};
  }
  const int k = largest_axis(camera.eye.at);
  std::array<Rational, 3> p = {origin.x, origin.y, origin.z};
  const auto at = [&](int axis) -> Rational& { return p[static_cast<std::size_t>(axis % 3)]; };
  at(k + 1) = at(k + 1) + q.x / q.z;
  at(k + 2) = at(k + 2) + q.y / q.z;
  return {p[0], p[1], p[2]};
}

Exact exact_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Point3& origin) {
  const RationalArithmetic a;
  auto q = polynomials::cross(polynomials::line(a, camera, l, origin), polynomials::line(a, camera, m, origin));
  const bool is_parallel = camera.eye.is_direction;
  const Rational w = is_parallel ? q.z : polynomials::dot(polynomials::difference(a, camera.target, camera.eye.at), q);
  require(w.sign() != Sign::zero, "exact_crossing: the lines are parallel in the image");
  return q;
}

/// Where the line of sight of p meets x.
std::array<Rational, 3> met(const Camera& camera, const Exact& p, const Plane& x) {
  const RationalArithmetic a;
  const auto plane = polynomials::plane_at_eye(a, camera, x);
  require(plane.at_eye.sign() != Sign::zero, "exact_point: the plane contains the viewpoint");
  const Point3& e = camera.eye.at;
  const Exact away =
      camera.eye.is_direction ? Exact{e.x, e.y, e.z} : Exact{p.x - Rational(e.x), p.y - Rational(e.y), p.z - Rational(e.z)};
  const Rational slope = polynomials::dot(plane.normal, away);
  // The value at p, from the eye or from x's own origin; only spans are faces.
  const Rational at_p =
      polynomials::dot(plane.normal, Exact{p.x - Rational(x.o.x), p.y - Rational(x.o.y), p.z - Rational(x.o.z)});
  require(slope.sign() != Sign::zero, "exact_point: the line of sight is parallel to the plane");
  const Rational s = at_p / slope;
  return {p.x - s * away.x, p.y - s * away.y, p.z - s * away.z};
}

/// A point of plane x on the line of sight with the coordinates q. Relative to x.o, so that no digits are lost.
std::array<ErrorBounded, 3> near_met(const Camera& camera, const Vector& q, const Plane& x) {
  const FilterArithmetic a;
  const auto plane = polynomials::plane_at_eye(a, camera, x);
  const Point3& e = camera.eye.at;
  const auto sum = [](double base, const ErrorBounded& d) { return ErrorBounded{base, 0} + d; };
  if (!camera.eye.is_direction) {
    // e + r q with x(e) + r n . q = 0.
    const ErrorBounded r = quotient(-plane.at_eye, polynomials::dot(plane.normal, q));
    return {sum(e.x, r * q.x), sum(e.y, r * q.y), sum(e.z, r * q.z)};
  }
  const int k = largest_axis(e);
  std::array<ErrorBounded, 3> d = {};
  const auto at = [&](int axis) -> ErrorBounded& { return d[static_cast<std::size_t>(axis % 3)]; };
  at(k + 1) = quotient(q.x, q.z);
  at(k + 2) = quotient(q.y, q.z);
  const ErrorBounded s = quotient(polynomials::dot(plane.normal, Vector{d[0], d[1], d[2]}), plane.at_eye);
  const auto along = [&](int axis) { return d[static_cast<std::size_t>(axis)] - s * ErrorBounded{e[axis], 0}; };
  return {sum(x.o.x, along(0)), sum(x.o.y, along(1)), sum(x.o.z, along(2))};
}

std::array<Rational, 2> exact_image_of_ray(const Camera& camera, const Exact& q, const std::array<Point3, 2>& rows) {
  const RationalArithmetic a;
  if (camera.eye.is_direction) return {q.x / q.z, q.y / q.z};
  const Rational depth = polynomials::dot(polynomials::difference(a, camera.target, camera.eye.at), q);
  const auto along = [&](const Point3& row) { return polynomials::dot(Exact{row.x, row.y, row.z}, q) / depth; };
  return {along(rows[0]), along(rows[1])};
}

}  // namespace

std::array<Rational, 3> exact_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x) {
  return met(camera, point_of_ray(camera, exact_crossing(camera, l, m, x.o), x.o), x);
}

std::array<Rational, 3> exact_point(const Camera& camera, const Point3& p, const Plane& x) {
  return met(camera, {p.x, p.y, p.z}, x);
}

std::array<ErrorBounded, 3> near_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x) {
  const FilterArithmetic a;
  return near_met(camera, polynomials::cross(polynomials::line(a, camera, l, x.o), polynomials::line(a, camera, m, x.o)), x);
}

std::array<Rational, 2> exact_image_of_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m,
                                                const Point3& origin, const std::array<Point3, 2>& rows) {
  return exact_image_of_ray(camera, exact_crossing(camera, l, m, origin), rows);
}

std::array<Rational, 2> exact_image_of_point(const Camera& camera, const Point3& p, const Point3& origin,
                                             const std::array<Point3, 2>& rows) {
  const RationalArithmetic a;
  if (!camera.eye.is_direction) return exact_image_of_ray(camera, polynomials::difference(a, p, camera.eye.at), rows);
  const Point3& d = camera.eye.at;
  const int k = largest_axis(d), i = (k + 1) % 3, j = (k + 2) % 3;
  const Rational along = a.difference(p, origin, k) / Rational(d[k]);
  return {a.difference(p, origin, i) - Rational(d[i]) * along, a.difference(p, origin, j) - Rational(d[j]) * along};
}

}  // namespace hsr
