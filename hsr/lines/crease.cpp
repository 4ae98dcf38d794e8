#include "hsr/lines/crease.h"

#include <algorithm>

#include "geometry/plane_filter.h"
#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"
#include "geometry/vector3.h"

namespace hsr::internal {

namespace {

/// Brought near length 1, so that no product underflows.
Point3 scaled(const Point3& a) { return over(a, norm_max(a)); }

/// The normal of the plane of a, b and c, good to nine digits; where doubles have cancelled, by rationals.
Point3 normal(const Point3& a, const Point3& b, const Point3& c) {
  const Plane plane = Plane::of_face(a, b, c);
  const PlaneFilter filter(plane, Arithmetic::staged);
  const Point3 n = {filter.nx, filter.ny, filter.nz};
  if (norm_max(n) > filter.slope * 0x1p30 && norm_max(n) > filter.least && norm_max(n) < 0x1p900) return scaled(n);
  const auto exact = polynomials::normal(RationalArithmetic{}, plane);
  Rational most;
  for (const Rational& x : {exact.x, exact.y, exact.z}) most = std::max(most, x.sign() == Sign::negative ? -x : x);
  return {(exact.x / most).to_double(), (exact.y / most).to_double(), (exact.z / most).to_double()};
}

}  // namespace

double deviation_from_flat(const ProjectedMesh& projected, const Edge& edge, VertexId in_one, VertexId in_other) {
  const Point3 &a = projected.point(edge.a), &b = projected.point(edge.b);
  const Point3 n0 = normal(a, b, projected.point(in_one)), n1 = normal(a, b, projected.point(in_other));
  const Point3 n = cross(n0, n1);
  return std::atan2(std::sqrt(dot(n, n)), -dot(n0, n1)) * 180 / std::numbers::pi;
}

}  // namespace hsr::internal
