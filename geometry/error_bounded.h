#pragma once

#include <cmath>

namespace hsr {

/// A double and a bound of its distance to the exact result: the first stage of every predicate.
///
/// With u = 2^-53, round to nearest and gradual underflow:
///   sum      |fl(a+b) - (A+B)|  <=  e_a + e_b + u |fl(a+b)|                              (a sum never underflows)
///   product  |fl(ab) - AB|      <=  |a| e_b + |b| e_a + e_a e_b + u |fl(ab)| + 2^-1075
/// The bound itself is computed with at most seven roundings, each of relative error u, and four products that may lose 2^-1075
/// each; the factor `grow` and the term `lost` cover them. An overflow makes u |fl| and so the bound infinite (or not a
/// number), and a sign is certain only where |value| > error, which then does not hold.
struct ErrorBounded {
  double value = 0, error = 0;

  static constexpr double u = 0x1p-53, grow = 1 + 0x1p-48, lost = 0x1p-1070;

  bool is_certain() const { return std::fabs(value) > error; }
};

inline ErrorBounded operator+(ErrorBounded a, ErrorBounded b) {
  const double v = a.value + b.value;
  return {v, (a.error + b.error + ErrorBounded::u * std::fabs(v)) * ErrorBounded::grow};
}
inline ErrorBounded operator-(ErrorBounded a) { return {-a.value, a.error}; }
inline ErrorBounded operator-(ErrorBounded a, ErrorBounded b) { return a + -b; }
inline ErrorBounded operator*(ErrorBounded a, ErrorBounded b) {
  const double v = a.value * b.value;
  return {v,
          (std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error + ErrorBounded::u * std::fabs(v)) *
                  ErrorBounded::grow +
              ErrorBounded::lost};
}

/// |a/b - A/B| <= (e_a + |a/b| e_b) / (|b| - e_b) + u |a/b|; the factor pays for the roundings of the bound. An error that is
/// not finite where b may be zero.
inline ErrorBounded quotient(ErrorBounded a, ErrorBounded b) {
  if (!(std::fabs(b.value) > 2 * b.error)) return {0, HUGE_VAL};
  const double q = a.value / b.value;
  const double error =
      ((a.error + std::fabs(q) * b.error) / (std::fabs(b.value) - b.error) + ErrorBounded::u * std::fabs(q)) * 1.01 + 0x1p-1000;
  if (!(std::fabs(q) + error < HUGE_VAL)) return {0, HUGE_VAL};
  return {q, error};
}

}  // namespace hsr
