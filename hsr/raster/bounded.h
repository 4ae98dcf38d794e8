#pragma once

#include <cmath>
#include <limits>

#include "geometry/error_bounded.h"

namespace hsr::internal {

/// A number as a picture in floats or doubles has it, and how far from it the true one is at most: ErrorBounded for any Real,
/// with the value that Real itself gives, whatever the bound.
template <class Real>
struct Bounded {
  Real value = 0;
  double error = 0;

  static constexpr double u = std::numeric_limits<Real>::epsilon() / 2.0, lost = std::numeric_limits<Real>::denorm_min();
  static constexpr double grow = ErrorBounded::grow;

  friend Bounded operator+(Bounded a, Bounded b) {
    const Real v = a.value + b.value;
    return {v, (a.error + b.error + u * std::fabs(static_cast<double>(v))) * grow};
  }
  friend Bounded operator-(Bounded a) { return {-a.value, a.error}; }
  friend Bounded operator-(Bounded a, Bounded b) { return a + -b; }
  friend Bounded operator*(Bounded a, Bounded b) {
    const Real v = a.value * b.value;
    const double e = std::fabs(static_cast<double>(a.value)) * b.error + std::fabs(static_cast<double>(b.value)) * a.error +
                     a.error * b.error + u * std::fabs(static_cast<double>(v));
    return {v, e * grow + lost};
  }
  friend Bounded operator/(Bounded a, Bounded b) {
    const Real v = a.value / b.value;
    const double q = std::fabs(static_cast<double>(v)), below = std::fabs(static_cast<double>(b.value)) - b.error;
    if (!(below > b.error)) return {v, HUGE_VAL};
    return {v, ((a.error + q * b.error) / below + u * q) * 1.01 + lost};
  }
};

/// What comparisons look at.
template <class Real>
Real raw(const Bounded<Real>& x) {
  return x.value;
}
inline float raw(float x) { return x; }
inline double raw(double x) { return x; }

}  // namespace hsr::internal
