#pragma once

#include <gmp.h>

#include <compare>
#include <string>

namespace hsr {

/// The answer of a predicate.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }
template <class T>
constexpr Sign sign_of(const T& x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

/// An exact rational number in lowest terms (a GMP mpq). For output and for tests: no predicate computes with it.
class Rational {
 public:
  Rational() { mpq_init(q_); }
  /// Every finite double is a rational. @throws PreconditionError unless finite
  Rational(double x);  // NOLINT(google-explicit-constructor)
  Rational(const Rational& o) : Rational() { mpq_set(q_, o.q_); }
  /// What is left may be assigned to and destroyed, and nothing else. It takes no memory: mpz_init() does not.
  Rational(Rational&& o) noexcept {
    *q_ = *o.q_;
    mpz_init(mpq_numref(o.q_));
    mpz_init(mpq_denref(o.q_));
  }
  Rational& operator=(const Rational& o) {
    mpq_set(q_, o.q_);
    return *this;
  }
  Rational& operator=(Rational&& o) noexcept {
    mpq_swap(q_, o.q_);
    return *this;
  }
  ~Rational() { mpq_clear(q_); }

  /// @throws PreconditionError unless `text` is "p" or "p/q" with q > 0
  static Rational from_string(const std::string& text);

  Sign sign() const { return static_cast<Sign>(mpq_sgn(q_)); }
  /// The nearest double, ties to even, subnormals included; beyond the largest double, an infinity.
  double to_double() const;
  /// "p/q" in lowest terms, "p" when whole.
  std::string to_string() const;
  /// The number rounded to `digits` decimals after the point, half away from zero, without trailing zeros.
  std::string to_decimal(int digits) const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);  ///< @throws PreconditionError if b is 0
  friend Rational operator-(const Rational& a) { return Rational() - a; }
  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.q_, b.q_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return mpq_cmp(a.q_, b.q_) <=> 0; }

  mpq_srcptr get() const { return q_; }
  mpq_ptr get() { return q_; }

 private:
  mpq_t q_;
};

inline Sign sign_of(const Rational& x) { return x.sign(); }

}  // namespace hsr
