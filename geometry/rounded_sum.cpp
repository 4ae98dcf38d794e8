#include "geometry/rounded_sum.h"

#include <algorithm>
#include <limits>

namespace hsr {

namespace {

/// k of a power of two 2^k above |x|. @pre x is not zero
long exponent_above(const Rational& x) {
  return static_cast<long>(mpz_sizeinbase(mpq_numref(x.get()), 2)) - static_cast<long>(mpz_sizeinbase(mpq_denref(x.get()), 2)) +
         1;
}

/// x 2^k, k of any sign.
void scale(Rational& x, long k) {
  if (k >= 0)
    mpq_mul_2exp(x.get(), x.get(), static_cast<mp_bitcnt_t>(k));
  else
    mpq_div_2exp(x.get(), x.get(), static_cast<mp_bitcnt_t>(-k));
}

}  // namespace

double rounded_sum(const std::vector<const Rational*>& terms) {
  constexpr std::size_t few = 3;
  if (terms.size() > few) {
    long exponent = std::numeric_limits<long>::min();
    for (const Rational* x : terms)
      if (x->sign() != Sign::zero) exponent = std::max(exponent, exponent_above(*x));
    if (exponent == std::numeric_limits<long>::min()) return 0;
    // Down to whole multiples of the largest term's 2^-192: each term lies less than one above what is added.
    const long place = exponent - 192;
    Rational low, scaled;
    for (const Rational* x : terms) {
      scaled = *x;
      scale(scaled, -place);
      mpz_fdiv_q(mpq_numref(scaled.get()), mpq_numref(scaled.get()), mpq_denref(scaled.get()));
      mpz_add(mpq_numref(low.get()), mpq_numref(low.get()), mpq_numref(scaled.get()));
    }
    Rational high = low + Rational(static_cast<double>(terms.size()));
    scale(low, place);
    scale(high, place);
    const double rounded = low.to_double();
    if (rounded == high.to_double()) return rounded;
  }
  Rational sum;
  for (const Rational* x : terms) sum = sum + *x;
  return sum.to_double();
}

}  // namespace hsr
