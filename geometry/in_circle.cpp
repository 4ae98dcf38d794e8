#include "geometry/in_circle.h"

#include <cmath>
#include <cstdlib>

#include "geometry/arithmetics.h"
#include "geometry/polynomials.h"

namespace hsr::internal {

namespace {

/// A sign of in_circle_value that is certainly right, or zero where doubles cannot tell.
///
/// With u = 2^-53: a squared distance, a sum of three squares, carries a relative error of at most 5.1u; a minor at most 4.1u of
/// the sum of its two products' magnitudes (flat_orientation.h); their product one rounding more, and the two sums of three such
/// terms 2u of the sum of all magnitudes. Together 12.3u of that sum; 16u pays for the roundings of the bound itself. Lost
/// products: every difference is below 2^100, so that what underflows changes the value by less than 2^-860.
Sign certain_in_circle(const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis) {
  const int i = axis == 2 ? 0 : axis + 1;
  const int j = axis == 0 ? 2 : axis - 1;
  const Point3 p{a.x - d.x, a.y - d.y, a.z - d.z}, q{b.x - d.x, b.y - d.y, b.z - d.z}, r{c.x - d.x, c.y - d.y, c.z - d.z};
  const double pp = p.x * p.x + p.y * p.y + p.z * p.z, qq = q.x * q.x + q.y * q.y + q.z * q.z,
               rr = r.x * r.x + r.y * r.y + r.z * r.z;
  if (!(pp < 0x1p200 && qq < 0x1p200 && rr < 0x1p200)) return Sign::zero;
  const double qr = q[i] * r[j], rq = q[j] * r[i], rp = r[i] * p[j], pr = r[j] * p[i], pq = p[i] * q[j], qp = p[j] * q[i];
  const double value = pp * (qr - rq) + qq * (rp - pr) + rr * (pq - qp);
  const double all =
      pp * (std::fabs(qr) + std::fabs(rq)) + qq * (std::fabs(rp) + std::fabs(pr)) + rr * (std::fabs(pq) + std::fabs(qp));
  const double bound = 0x1p-49 * all + 0x1p-850;
  return value > bound ? Sign::positive : value < -bound ? Sign::negative : Sign::zero;
}

}  // namespace

/// A term is a product of four differences; there are 18 of them and a sign.
InCircle::InCircle(const BitRange& points)
    : lowest_(points.lowest),
      bits_(4 * (points.bits() + 1) + 6),
      scale_(std::abs(points.lowest) <= 1000 ? std::ldexp(1.0, -points.lowest) : 0) {}

Sign InCircle::operator()(const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis) const {
  const Sign certain = certain_in_circle(a, b, c, d, axis);
  if (certain != Sign::zero) return certain;
  const auto value = [&](const auto& k) { return polynomials::in_circle_value(k, a, b, c, d, axis); };
  if (bits_ <= 127 && scale_ != 0) return sign_of(value(NarrowArithmetic{scale_, 0}));
  {
    const CGAL::Protect_FPU_rounding<true> directed;
    const auto x = value(IntervalArithmetic{});
    if (x.inf() > 0) return Sign::positive;
    if (x.sup() < 0) return Sign::negative;
    if (x.inf() == 0 && x.sup() == 0) return Sign::zero;
  }
  if (bits_ <= 192) return value(FixedArithmetic<3>{lowest_, 0}).sign();
  if (bits_ <= 384) return value(FixedArithmetic<6>{lowest_, 0}).sign();
  return static_cast<Sign>(static_cast<int>(CGAL::sign(value(BigArithmetic{}))));
}

}  // namespace hsr::internal
