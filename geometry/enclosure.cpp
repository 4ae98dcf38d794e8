#include "geometry/enclosure.h"

namespace hsr::internal {

Rational power_of_two(long k) {
  Rational x = 1.0;
  if (k >= 0)
    mpq_mul_2exp(x.get(), x.get(), static_cast<mp_bitcnt_t>(k));
  else
    mpq_div_2exp(x.get(), x.get(), static_cast<mp_bitcnt_t>(-k));
  return x;
}

Enclosure enclose(const Rational& x) {
  if (x.sign() == Sign::zero) return {};
  // Scaled to about 1, so that neither of the two doubles that carry it leaves the range.
  const long exponent =
      static_cast<long>(mpz_sizeinbase(mpq_numref(x.get()), 2)) - static_cast<long>(mpz_sizeinbase(mpq_denref(x.get()), 2));
  const Rational scaled = x * power_of_two(-exponent);
  const double first = scaled.to_double(), second = (scaled - first).to_double();
  using Wide = Enclosure::Wide;
  const Wide sum = std::ldexp(static_cast<Wide>(first) + second, static_cast<int>(exponent));
  return {sum, 4 * Enclosure::eps * std::fabs(sum) + Enclosure::least};
}

std::optional<double> rounded(const Enclosure& x) {
  const auto low = static_cast<double>(x.low()), high = static_cast<double>(x.high());
  if (!(low == high) || !std::isfinite(low)) return {};
  return low + 0.0;
}

}  // namespace hsr::internal
