#include "geometry/rounded_sum.h"

#include <algorithm>
#include <limits>

#include "geometry/enclosure.h"

namespace hsr::internal {

namespace {

/// k of a power of two 2^k above |x|. @pre x is not zero
long exponent_above(const Rational& x) {
  return static_cast<long>(mpz_sizeinbase(mpq_numref(x.get()), 2)) - static_cast<long>(mpz_sizeinbase(mpq_denref(x.get()), 2)) +
         1;
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
    const Rational unit = power_of_two(place), per_unit = power_of_two(-place);
    Rational low;
    for (const Rational* x : terms) {
      Rational scaled = *x * per_unit;
      mpz_fdiv_q(mpq_numref(scaled.get()), mpq_numref(scaled.get()), mpq_denref(scaled.get()));
      mpz_add(mpq_numref(low.get()), mpq_numref(low.get()), mpq_numref(scaled.get()));
    }
    const Rational high = low + Rational(static_cast<double>(terms.size()));
    const double rounded = (low * unit).to_double();
    if (rounded == (high * unit).to_double()) return rounded;
  }
  Rational sum;
  for (const Rational* x : terms) sum = sum + *x;
  return sum.to_double();
}

}  // namespace hsr::internal
