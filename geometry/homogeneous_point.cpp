#include "geometry/homogeneous_point.h"

#include "geometry/arithmetics.h"

namespace hsr::internal {

namespace {

using Big = BigArithmetic::Number;
using Bigs = std::array<Big, 4>;

Big big(const Rational& whole) {
  if (whole.sign() == Sign::zero) return 0;
  Big magnitude;
  magnitude.init_from_mpz_t(mpq_numref(whole.get()));  // which leaves out the sign
  return whole.sign() == Sign::negative ? -magnitude : magnitude;
}

Bigs bigs(const HomogeneousPoint3& p) { return {big(p.h[0]), big(p.h[1]), big(p.h[2]), big(p.h[3])}; }

}  // namespace

HomogeneousPoint3 HomogeneousPoint3::of(const RationalVector& p) {
  HomogeneousPoint3 out;
  Rational& weight = out.h[3];
  weight = 1.0;
  for (const Rational& x : p) mpz_lcm(mpq_numref(weight.get()), mpq_numref(weight.get()), mpq_denref(x.get()));
  for (std::size_t k = 0; k < 3; ++k) out.h[k] = p[k] * weight;
  return out;
}

HomogeneousPoint3 HomogeneousPoint3::of_direction(const RationalVector& d) {
  HomogeneousPoint3 out = of(d);
  out.h[3] = 0.0;
  return out;
}

// By minors of two rows each (Laplace); the determinant of the four rows (x, y, z, w) is -det(b - a, c - a, d - a) times the
// weights.
Sign orientation(const HomogeneousPoint3& a, const HomogeneousPoint3& b, const HomogeneousPoint3& c,
                 const HomogeneousPoint3& d) {
  const Bigs p = bigs(a), q = bigs(b), r = bigs(c), s = bigs(d);
  const auto minor = [](const Bigs& x, const Bigs& y, std::size_t i, std::size_t k) { return x[i] * y[k] - x[k] * y[i]; };
  const Big sum = minor(p, q, 0, 1) * minor(r, s, 2, 3) - minor(p, q, 0, 2) * minor(r, s, 1, 3) +
                  minor(p, q, 0, 3) * minor(r, s, 1, 2) + minor(p, q, 1, 2) * minor(r, s, 0, 3) -
                  minor(p, q, 1, 3) * minor(r, s, 0, 2) + minor(p, q, 2, 3) * minor(r, s, 0, 1);
  return -sign_of(static_cast<int>(CGAL::sign(sum)));
}

}  // namespace hsr::internal
