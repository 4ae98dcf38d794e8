#include "hsr/painter/verify/painted_points.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "geometry/bounded_rational.h"
#include "geometry/enclosure.h"
#include "geometry/near_value.h"
#include "geometry/polynomials.h"

namespace hsr::internal {

namespace {

std::optional<double> as_double(const Rational& x) {
  const double d = mpq_get_d(x.get()) + 0.0;
  if (!std::isfinite(d) || Rational(d) != x) return {};
  return d;
}

std::optional<Point3> as_point(const RationalVector& p) {
  const auto x = as_double(p[0]), y = as_double(p[1]), z = as_double(p[2]);
  if (!x || !y || !z) return {};
  return Point3{*x, *y, *z};
}

using Near = polynomials::Vector<ErrorBounded>;

Near minus(const std::array<ErrorBounded, 3>& a, const std::array<ErrorBounded, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

ErrorBounded determinant(const Near& a, const Near& b, const Near& c) { return polynomials::dot(polynomials::cross(a, b), c); }

std::vector<SectionPlane> planes_of(const View& view) {
  std::vector<SectionPlane> all = view.planes;
  if (view.section) all.push_back(*view.section);
  if (view.far) all.push_back(*view.far);
  return all;
}

BitRange with_view(BitRange points, const View& view) {
  for (const SectionPlane& plane : planes_of(view)) points.add(plane.point);
  if (!view.is_perspective()) return points;
  points.add(view.viewpoint.at);
  points.add(view.target);
  return points;
}

BitRange of_direction(const View& view) {
  BitRange c;
  if (!view.is_perspective()) c.add(view.viewpoint.at);
  for (const SectionPlane& plane : planes_of(view)) c.add(plane.normal);
  return c;
}

}  // namespace

std::size_t PaintedPoints::Hash::operator()(const Point3& p) const {
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[axis])) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32U;
  }
  return h;
}

PaintedPoints::PaintedPoints(const std::vector<PaintedPolygon>& polygons) {
  Ragged<std::optional<Point3>> given;
  for (const PaintedPolygon& p : polygons) given.push_row(std::vector<std::optional<Point3>>(p.corners.size()));
  tbb::parallel_for(std::size_t{0}, polygons.size(), [&](std::size_t i) {
    for (std::size_t k = 0; k < polygons[i].corners.size(); ++k) given[i][k] = as_point(polygons[i].corners[k]);
  });
  corners_.reserve(given.size(), given.values().size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t k = 0; k < polygons[i].corners.size(); ++k) {
      const auto& p = given[i][k];
      corners_.push_back(p ? add_double(*p) : add_rational(polygons[i].corners[k]));
    }
    corners_.end_row();
  }
  for (std::uint32_t n = 0; n < points_.size(); ++n)
    if (is_double(n)) bit_range_.add(points_[n]);
}

std::uint32_t PaintedPoints::number_of(const RationalVector& p) {
  // A new one stays a rational even where it is a double: the bit range is not of it.
  if (const auto d = as_point(p))
    if (const auto seen = doubles_seen_.find(*d); seen != doubles_seen_.end()) return seen->second;
  return add_rational(p);
}

std::uint32_t PaintedPoints::add_double(const Point3& p) {
  const auto [at, is_new] = doubles_seen_.emplace(p, static_cast<std::uint32_t>(points_.size()));
  if (is_new) {
    points_.push_back(p);
    exact_.push_back(not_exact);
    near_.push_back({ErrorBounded{p.x, 0}, ErrorBounded{p.y, 0}, ErrorBounded{p.z, 0}});
  }
  return at->second;
}

std::uint32_t PaintedPoints::add_rational(const RationalVector& p) {
  const auto [at, is_new] = rationals_seen_.emplace(p, static_cast<std::uint32_t>(points_.size()));
  if (is_new) {
    points_.emplace_back();
    exact_.push_back(static_cast<std::uint32_t>(rationals_.size()));
    rationals_.push_back(p);
    wholes_.push_back(HomogeneousPoint3::of(p));
    near_.push_back({bounded(p[0]), bounded(p[1]), bounded(p[2])});
  }
  return at->second;
}

HomogeneousPoint3 PaintedPoints::whole(std::uint32_t number) const {
  return is_double(number) ? HomogeneousPoint3::of(rational(points_[number])) : wholes_[exact_[number]];
}

void PaintedPoints::place(const ImageRows& rows) {
  std::array<std::array<Enclosure, 3>, 3> along;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) along[k][i] = enclose(k < 2 ? rows.across[k][i] : rows.away[i]);
  std::array<double, 3> eye = {};
  if (!rows.parallel)
    for (std::size_t i = 0; i < 3; ++i) eye[i] = rows.eye[i].to_double();  // exact: it was given as doubles
  places_.resize(points_.size());
  tbb::parallel_for(std::size_t{0}, places_.size(), [&](std::size_t number) {
    const auto c = static_cast<std::uint32_t>(number);
    std::array<Enclosure, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      d[i] = is_double(c) ? Enclosure::difference(points_[c][static_cast<int>(i)], eye[i])
                          : enclose(rationals_[exact_[c]][i]) - Enclosure(eye[i]);
    const auto dot = [&](std::size_t k) { return d[0] * along[k][0] + d[1] * along[k][1] + d[2] * along[k][2]; };
    std::array<Enclosure, 2> at = {dot(0), dot(1)};
    if (!rows.parallel) {
      const Enclosure depth = dot(2);
      if (!depth.is_positive()) return;
      at = {at[0] / depth, at[1] / depth};
    }
    // To doubles: a relative 2^-53 of each, or what underflows.
    const auto error = [](const Enclosure& x) {
      return static_cast<double>(x.error) * 1.01 + std::fabs(static_cast<double>(x.middle)) * 0x1p-50 + 0x1p-1070;
    };
    const BoundedPoint2 place = {{static_cast<double>(at[0].middle), static_cast<double>(at[1].middle)},
                                 std::max(error(at[0]), error(at[1]))};
    if (std::isfinite(place.p.x) && std::isfinite(place.p.y) && std::isfinite(place.error)) places_[number] = place;
  });
}

PaintedSides::PaintedSides(const PaintedPoints& points, const ImageRows& rows, const View& view)
    : points_(points),
      rows_(rows),
      view_(view),
      whole_eye_(rows.parallel ? HomogeneousPoint3::of_direction(rows.eye) : HomogeneousPoint3::of(rows.eye)),
      predicates_(with_view(points.bit_range(), view), of_direction(view)) {}

Sign PaintedSides::turn(std::uint32_t a, std::uint32_t b, std::uint32_t p) {
  if (p == a || p == b) return Sign::zero;
  if (points_.are_placed())
    if (const Sign s = certain_turn_in_image(a, b, p); s != Sign::zero) return s;
  return turn_in_space(a, b, p);
}

/// Zero: doubles cannot tell. With d = b - a and r = p - a as computed, their entries off by E = e_a + e_b and F = e_a + e_p
/// and one rounding u of their own, |det - exact| <= E |r|_1 + F |d|_1 + 2 E F + 4.1 u |d|_1 |r|_1 + what underflows.
Sign PaintedSides::certain_turn_in_image(std::uint32_t a, std::uint32_t b, std::uint32_t p) const {
  const BoundedPoint2 &from = points_.place_of(a), &to = points_.place_of(b), &at = points_.place_of(p);
  const double dx = to.p.x - from.p.x, dy = to.p.y - from.p.y, rx = at.p.x - from.p.x, ry = at.p.y - from.p.y;
  const double d = std::fabs(dx) + std::fabs(dy), r = std::fabs(rx) + std::fabs(ry);
  const double e = from.error + to.error, f = from.error + at.error;
  const double det = dx * ry - dy * rx;
  const double bound = ((e + 4.2 * ErrorBounded::u * d) * r + f * d + 2 * e * f) * 1.01 + 0x1p-1000;
  if (!(std::fabs(det) < HUGE_VAL)) return Sign::zero;  // a product overflowed
  return det > bound ? Sign::positive : det < -bound ? Sign::negative : Sign::zero;
}

Sign PaintedSides::turn_in_space(std::uint32_t a, std::uint32_t b, std::uint32_t p) {
  if (points_.is_double(a) && points_.is_double(b) && points_.is_double(p))
    return predicates_.side(Plane::of_sight(view_.viewpoint, points_.point(a), points_.point(b)), points_.point(p));
  const Point3& e = view_.viewpoint.at;
  const std::array<ErrorBounded, 3> eye = {ErrorBounded{e.x, 0}, ErrorBounded{e.y, 0}, ErrorBounded{e.z, 0}};
  const auto &c = points_.near(a), &d = points_.near(b), &at = points_.near(p);
  const ErrorBounded near = rows_.parallel ? determinant(Near{eye[0], eye[1], eye[2]}, minus(d, c), minus(at, c))
                                           : determinant(minus(d, eye), minus(c, eye), minus(at, eye));
  if (near.is_certain()) return sign_of(near.value);
  const HomogeneousPoint3 from = points_.whole(a), to = points_.whole(b), whole = points_.whole(p);
  return rows_.parallel ? orientation(from, whole_eye_, to, whole) : orientation(whole_eye_, to, from, whole);
}

Sign PaintedSides::side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) {
  if (p == a || p == b || p == c) return Sign::zero;
  if (points_.is_double(a) && points_.is_double(b) && points_.is_double(c) && points_.is_double(p))
    return predicates_.side(Plane::of_face(points_.point(a), points_.point(b), points_.point(c)), points_.point(p));
  const auto& o = points_.near(a);
  const ErrorBounded near = determinant(minus(points_.near(b), o), minus(points_.near(c), o), minus(points_.near(p), o));
  if (near.is_certain()) return sign_of(near.value);
  return orientation(points_.whole(a), points_.whole(b), points_.whole(c), points_.whole(p));
}

Sign PaintedSides::side(const Plane& plane, std::uint32_t p) {
  if (points_.is_double(p)) return predicates_.side(plane, points_.point(p));
  return near_value(plane, points_.exact(p)).sign();
}

}  // namespace hsr::internal
