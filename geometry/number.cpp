#include "geometry/number.h"

#include <cmath>
#include <limits>

#include "geometry/error.h"

namespace hsr {

Rational::Rational(double x) : Rational() {
  require(std::isfinite(x), "Rational: a finite double expected");
  mpq_set_d(q_, x);
}

Rational Rational::from_string(const std::string& text) {
  Rational r;
  const auto digits = text.find_first_not_of("-0123456789/");
  require(
      !text.empty() && digits == std::string::npos && mpq_set_str(r.q_, text.c_str(), 10) == 0 && mpz_sgn(mpq_denref(r.q_)) > 0,
      "Rational: \"p\" or \"p/q\" expected");
  mpq_canonicalize(r.q_);
  return r;
}

double Rational::to_double() const {
  if (mpq_sgn(q_) == 0) return 0;
  // Both are doubles: a division rounds once.
  constexpr std::size_t most_bits = 53;
  if (mpz_sizeinbase(mpq_numref(q_), 2) <= most_bits && mpz_sizeinbase(mpq_denref(q_), 2) <= most_bits)
    return mpz_get_d(mpq_numref(q_)) / mpz_get_d(mpq_denref(q_));
  mpz_t n, d, rest;
  mpz_init(n);
  mpz_init(d);
  mpz_init(rest);
  mpz_abs(n, mpq_numref(q_));
  mpz_set(d, mpq_denref(q_));
  // |q| lies in [2^e, 2^(e+2)). Scale so that the integer quotient keeps 55 or 56 bits, or as many as reach one bit below the
  // last subnormal place 2^-1074: then one rounding, with the remainder as a sticky bit, is the only one.
  const long e = static_cast<long>(mpz_sizeinbase(n, 2)) - static_cast<long>(mpz_sizeinbase(d, 2)) - 1;
  const long shift = std::min(55 - e, 1076L);
  if (shift > 0)
    mpz_mul_2exp(n, n, static_cast<mp_bitcnt_t>(shift));
  else
    mpz_mul_2exp(d, d, static_cast<mp_bitcnt_t>(-shift));
  mpz_tdiv_qr(n, rest, n, d);
  const bool sticky = mpz_sgn(rest) != 0;
  const auto bits = static_cast<long>(mpz_sizeinbase(n, 2));
  // Places of n that the double does not keep: past 53 bits, or below 2^-1074.
  const long cut = std::max(bits - 53, shift - 1074);
  mpz_fdiv_r_2exp(rest, n, static_cast<mp_bitcnt_t>(cut));
  mpz_fdiv_q_2exp(n, n, static_cast<mp_bitcnt_t>(cut));
  mpz_mul_2exp(rest, rest, 1);
  mpz_set_ui(d, 1);
  mpz_mul_2exp(d, d, static_cast<mp_bitcnt_t>(cut));
  const int half = mpz_cmp(rest, d);
  if (half > 0 || (half == 0 && (sticky || mpz_odd_p(n) != 0))) mpz_add_ui(n, n, 1);
  const double magnitude = std::ldexp(mpz_get_d(n), static_cast<int>(cut - shift));
  mpz_clear(n);
  mpz_clear(d);
  mpz_clear(rest);
  return mpq_sgn(q_) < 0 ? -magnitude : magnitude;
}

std::string Rational::to_string() const {
  char* text = mpq_get_str(nullptr, 10, q_);
  std::string s = text;
  void (*release)(void*, std::size_t) = nullptr;
  mp_get_memory_functions(nullptr, nullptr, &release);
  release(text, s.size() + 1);
  return s;
}

std::string Rational::to_decimal(int digits) const {
  mpz_t n, ten;
  mpz_init(n);
  mpz_init(ten);
  mpz_ui_pow_ui(ten, 10, static_cast<unsigned long>(digits));
  mpz_abs(n, mpq_numref(q_));
  mpz_mul(n, n, ten);
  mpz_mul_2exp(n, n, 1);
  mpz_add(n, n, mpq_denref(q_));
  mpz_mul_2exp(ten, mpq_denref(q_), 1);
  mpz_fdiv_q(n, n, ten);  // floor(|q| 10^digits + 1/2)
  Rational whole;
  mpq_set_z(whole.q_, n);
  mpz_clear(n);
  mpz_clear(ten);
  std::string s = whole.to_string();
  if (s == "0") return s;
  const auto places = static_cast<std::size_t>(digits);
  if (s.size() <= places) s.insert(0, places + 1 - s.size(), '0');
  if (places > 0) {
    s.insert(s.size() - places, 1, '.');
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
  }
  if (mpq_sgn(q_) < 0) s.insert(0, 1, '-');
  return s;
}

Rational operator+(const Rational& a, const Rational& b) {
  Rational r;
  mpq_add(r.q_, a.q_, b.q_);
  return r;
}
Rational operator-(const Rational& a, const Rational& b) {
  Rational r;
  mpq_sub(r.q_, a.q_, b.q_);
  return r;
}
Rational operator*(const Rational& a, const Rational& b) {
  Rational r;
  mpq_mul(r.q_, a.q_, b.q_);
  return r;
}
Rational operator/(const Rational& a, const Rational& b) {
  require(b.sign() != Sign::zero, "Rational: division by zero");
  Rational r;
  mpq_div(r.q_, a.q_, b.q_);
  return r;
}

}  // namespace hsr
