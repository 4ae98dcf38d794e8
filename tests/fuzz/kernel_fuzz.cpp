// Bytes to planes and points: every predicate must have the sign of the rationals.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "geometry/plane_filter.h"
#include "geometry/polynomials.h"
#include "geometry/predicates.h"
#include "geometry/rational_arithmetic.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

void expect(bool holds) {
  if (!holds) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t count = 12;
  if (size < 1 + count * 3 * sizeof(double)) return 0;
  const std::uint8_t kinds = data[0];
  std::vector<Point3> p(count);
  std::memcpy(p.data(), data + 1, count * sizeof(Point3));
  for (Point3& q : p)
    for (double* x : {&q.x, &q.y, &q.z})
      if (!std::isfinite(*x)) *x = 1;
  const bool is_direction = (kinds & 1) != 0;
  const Viewpoint eye = {p[0], is_direction};
  BitRange direction;
  if (is_direction) direction.add(eye.at);
  Predicates predicates(bit_range(p), direction);
  const auto plane = [&](std::size_t i, int kind) {
    if (kind == 0) return Plane::of_face(p[i], p[i + 1], p[i + 2]);
    if (kind == 1) return Plane::of_sight(eye, p[i], p[i + 1]);
    if (kind == 2) return Plane::along_axis(p[i], p[i + 1], (kinds >> 3) % 3);
    return Plane::of_sight_along_axis(eye, p[i], (kinds >> 3) % 3);
  };
  const RationalArithmetic exact;
  const Plane a = plane(1, kinds >> 1 & 3), b = plane(4, kinds >> 2 & 3), c = plane(7, kinds >> 4 & 3),
              x = plane(2, kinds >> 5 & 3);
  const Sign side = sign_of(polynomials::value(exact, a, p[10]));
  expect(predicates.side(a, p[10]) == side);
  expect(predicates.cross(a, b, p[10], p[11]) == sign_of(polynomials::cross_value(exact, a, b, p[10], p[11])));
  const Sign meet = sign_of(polynomials::meet_value(exact, a, b, c));
  if (meet != Sign::zero)
    expect(predicates.side(x, a, b, c) == meet * sign_of(polynomials::meet_side_value(exact, x, a, b, c)));
  if (!is_direction) {
    for (const Plane& y : {Plane::near(eye.at, p[11], 0.001), Plane::near_line(eye.at, p[11], 0.001, a)})
      expect(predicates.side(y, p[10]) == sign_of(polynomials::value(exact, y, p[10])));
  }
  if (predicates.filter_is_proven()) {
    const ErrorBounded v = PlaneFilter(a, Arithmetic::staged)(p[10]);
    if (v.is_certain()) expect(sign_of(v.value) == side);
  }
  return 0;
}
