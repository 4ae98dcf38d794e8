#include "geometry/view_plane.h"

#include <cmath>

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/view_plane_polynomials.h"

namespace hsr {

using namespace internal;

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

using Big = BigArithmetic::Number;
using Exact = polynomials::Vector<Big>;

Big dot(const Point3& row, const Exact& q) { return Big(row.x) * q.x + Big(row.y) * q.y + Big(row.z) * q.z; }

/// The direction of the ray on which the lines of l and m cross, or the homogeneous coordinates of the crossing.
Exact exact_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Point3& origin) {
  const BigArithmetic a;
  auto q = polynomials::cross(polynomials::line(a, camera, l, origin), polynomials::line(a, camera, m, origin));
  const bool is_parallel = camera.eye.is_direction;
  const Big w = is_parallel ? q.z : polynomials::dot(polynomials::difference(a, camera.target, camera.eye.at), q);
  require(w != 0, "exact_crossing: the lines are parallel in the image");
  return q;
}

/// Where the ray from the eye with the direction q meets x: e - (x(e) / n . q) q.
std::array<Rational, 3> met_by_ray(const Camera& camera, const Exact& q, const Plane& x) {
  const BigArithmetic a;
  const auto plane = polynomials::plane_at_eye(a, camera, x);
  require(plane.at_eye != 0, "exact_point: the plane contains the viewpoint");
  const Big slope = polynomials::dot(plane.normal, q);
  require(slope != 0, "exact_point: the line of sight is parallel to the plane");
  const Point3& e = camera.eye.at;
  const auto along = [&](double from, const Big& toward) { return quotient(slope * Big(from) - plane.at_eye * toward, slope); };
  return {along(e.x, q.x), along(e.y, q.y), along(e.z, q.z)};
}

/// Where the line of sight of origin + d / w meets x, parallel: p - (x(p) / n . D) D.
std::array<Rational, 3> met_by_parallel(const Camera& camera, const Point3& origin, const Exact& d, const Big& w,
                                        const Plane& x) {
  const BigArithmetic a;
  const auto plane = polynomials::plane_at_eye(a, camera, x);
  require(plane.at_eye != 0, "exact_point: the plane contains the viewpoint");
  const Big at =
      polynomials::dot(plane.normal, d) + w * polynomials::dot(plane.normal, polynomials::difference(a, origin, x.o));
  const Big scale = w * plane.at_eye;
  const auto along = [&](int axis, const Big& from) {
    return quotient(scale * Big(origin[axis]) + plane.at_eye * from - at * Big(camera.eye.at[axis]), scale);
  };
  return {along(0, d.x), along(1, d.y), along(2, d.z)};
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
  const BigArithmetic a;
  if (camera.eye.is_direction) return {quotient(q.x, q.z), quotient(q.y, q.z)};
  const Big depth = polynomials::dot(polynomials::difference(a, camera.target, camera.eye.at), q);
  return {quotient(dot(rows[0], q), depth), quotient(dot(rows[1], q), depth)};
}

}  // namespace

std::array<Rational, 3> exact_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x) {
  const Exact q = exact_crossing(camera, l, m, x.o);
  if (!camera.eye.is_direction) return met_by_ray(camera, q, x);
  const int k = largest_axis(camera.eye.at);
  const Big none = 0;
  return met_by_parallel(camera, x.o,
                         k == 0   ? Exact{none, q.x, q.y}
                         : k == 1 ? Exact{q.y, none, q.x}
                                  : Exact{q.x, q.y, none},
                         q.z, x);
}

std::array<Rational, 3> exact_point(const Camera& camera, const Point3& p, const Plane& x) {
  if (!camera.eye.is_direction) return met_by_ray(camera, polynomials::difference(BigArithmetic{}, p, camera.eye.at), x);
  return met_by_parallel(camera, p, {0, 0, 0}, 1, x);
}

std::array<ErrorBounded, 3> bounded_point(const Camera& camera, const ViewPlane& l, const ViewPlane& m, const Plane& x) {
  const FilterArithmetic a;
  return near_met(camera, polynomials::cross(polynomials::line(a, camera, l, x.o), polynomials::line(a, camera, m, x.o)), x);
}

std::array<Rational, 2> exact_image_of_crossing(const Camera& camera, const ViewPlane& l, const ViewPlane& m,
                                                const Point3& origin, const std::array<Point3, 2>& rows) {
  return exact_image_of_ray(camera, exact_crossing(camera, l, m, origin), rows);
}

std::array<Rational, 2> exact_image_of_point(const Camera& camera, const Point3& p, const Point3& origin,
                                             const std::array<Point3, 2>& rows) {
  const BigArithmetic a;
  if (!camera.eye.is_direction) return exact_image_of_ray(camera, polynomials::difference(a, p, camera.eye.at), rows);
  const Point3& d = camera.eye.at;
  const int k = largest_axis(d), i = (k + 1) % 3, j = (k + 2) % 3;
  const auto share = [&](int axis) {
    return quotient(Big(d[k]) * a.difference(p, origin, axis) - Big(d[axis]) * a.difference(p, origin, k), d[k]);
  };
  return {share(i), share(j)};
}

}  // namespace hsr
