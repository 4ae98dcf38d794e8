#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/number.h"

namespace hsr::internal {

/// A real number known to lie within `error` of `middle`: decides almost every rounding and order of output coordinates; what
/// it leaves open, rationals decide.
///
/// With eps of the widest hardware type, for any rounding mode and gradual underflow:
///   sum       e_a + e_b + eps |fl(a + b)|
///   product   |a| e_b + |b| e_a + e_a e_b + eps |fl(ab)| + least
///   quotient  (e_a + |fl(a/b)| e_b) / (|b| - e_b) + eps |fl(a/b)| + least
/// Each bound is itself computed with at most eight roundings of relative error eps; `grow` covers them. Overflow and division
/// by an enclosure of zero make the error infinite or not a number: then nothing is certain, and nothing wrong is said.
struct Enclosure {
  using Wide = long double;
  static constexpr Wide eps = std::numeric_limits<Wide>::epsilon(), grow = 1 + 16 * eps,
                        least = std::numeric_limits<Wide>::denorm_min();

  Wide middle = 0, error = 0;

  Enclosure() = default;
  Enclosure(double exact) : middle(exact) {}  // NOLINT(google-explicit-constructor): every double is one
  Enclosure(Wide m, Wide e) : middle(m), error(e) {}

  Wide low() const { return middle - error - 4 * eps * (std::fabs(middle) + error); }
  Wide high() const { return middle + error + 4 * eps * (std::fabs(middle) + error); }
  bool is_positive() const { return middle > error; }
  bool is_finite() const { return std::isfinite(middle) && std::isfinite(error); }

  /// The integer that certainly is the nearest one; nothing near halves, from 2^62 on, and where too little is known.
  std::optional<std::int64_t> nearest_integer() const {
    if (!(std::fabs(middle) < 0x1p62L)) return {};
    const auto nearest = static_cast<std::int64_t>(std::llrint(middle));
    // The difference is exact; half a thousandth more than covers the rounding of the sum.
    return std::fabs(middle - static_cast<Wide>(nearest)) + error < 0.4995L ? std::optional(nearest) : std::nullopt;
  }

  /// a - b, without error where the difference is exact.
  static Enclosure difference(double a, double b) {
    const Wide d = static_cast<Wide>(a) - b;
    const Wide b_used = d - a, a_used = d - b_used;  // Knuth's two-sum: what the rounding took away
    const Wide lost = std::fabs(a - a_used) + std::fabs(-static_cast<Wide>(b) - b_used);
    return {d, lost == 0 ? 0 : eps * std::fabs(d)};
  }
};

inline Enclosure operator-(const Enclosure& a) { return {-a.middle, a.error}; }
inline Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  const auto m = a.middle + b.middle;
  return {m, (a.error + b.error + Enclosure::eps * std::fabs(m)) * Enclosure::grow};
}
inline Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + -b; }
inline Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  const auto m = a.middle * b.middle;
  if (m == 0 && ((a.middle == 0 && a.error == 0) || (b.middle == 0 && b.error == 0))) return {};
  return {m, (std::fabs(a.middle) * b.error + std::fabs(b.middle) * a.error + a.error * b.error +
              Enclosure::eps * std::fabs(m) + Enclosure::least) *
                 Enclosure::grow};
}
inline Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  if (b.middle == 1 && b.error == 0) return a;
  if (!(std::fabs(b.middle) > b.error)) return {0, std::numeric_limits<Enclosure::Wide>::infinity()};
  const auto m = a.middle / b.middle;
  const auto divisor = (std::fabs(b.middle) - b.error) * (1 - 4 * Enclosure::eps);
  return {m,
          ((a.error + std::fabs(m) * b.error * Enclosure::grow) / divisor + Enclosure::eps * std::fabs(m) + Enclosure::least) *
              Enclosure::grow};
}

/// Certainly less: false also where it cannot be told.
inline bool certainly_less(const Enclosure& a, const Enclosure& b) { return a.high() < b.low(); }

/// The enclosure of a rational, as narrow as the type allows.
Enclosure enclose(const Rational& x);

/// The nearest double, where the enclosure leaves no other.
std::optional<double> rounded(const Enclosure& x);

/// 2^k
Rational power_of_two(long k);

/// The numbers of geometry/polynomials.h as enclosures.
struct EnclosureArithmetic {
  using Number = Enclosure;
  template <class Point>
  static Number difference(const Point& p, const Point& q, int axis) {
    return Enclosure::difference(p[axis], q[axis]);
  }
  template <class Point>
  static Number direction(const Point& d, int axis) {
    return {d[axis]};
  }
  template <class Point>
  static Number axis(const Point& d, int axis) {
    return {d[axis]};
  }
  static Number scalar(double k) { return {k}; }
};

}  // namespace hsr::internal
