#include "hsr/io/read/gltf_transform.h"

#include <cmath>

#include "geometry/number.h"

namespace hsr::internal::read {

namespace {

double row(const double* m, const Point3& p) {
  const double terms[4][2] = {{m[0], p.x}, {m[1], p.y}, {m[2], p.z}, {m[3], 1}};
  // The sum in twice the precision: every product and sum is split into a double and its error, errors are summed in doubles.
  double sum = 0, low = 0, magnitude = 0;
  bool in_range = true;
  for (const auto& [a, b] : terms) {
    const double product = a * b;
    if (a == 0 || b == 0) continue;
    // Otherwise the error of the product may be no double.
    if (!(std::abs(product) > 0x1p-900 && std::abs(product) < 0x1p1000)) in_range = false;
    const double product_error = std::fma(a, b, -product);
    const double next = sum + product;
    const double part = next - sum;
    const double sum_error = (sum - (next - part)) + (product - part);
    sum = next;
    low += product_error + sum_error;
    magnitude += std::abs(product);
  }
  if (magnitude == 0) return 0;
  if (in_range) {
    // The errors are below 2^-52 of the magnitude each, and there are fewer than 16 roundings of them: 2^-53 * 2^-52 * 2^7.
    const double bound = magnitude * 0x1p-98;
    const double high = sum + (low + bound);
    if (high == sum + (low - bound) && high != 0) return high;
  }
  const Rational exact =
      Rational(m[0]) * Rational(p.x) + Rational(m[1]) * Rational(p.y) + Rational(m[2]) * Rational(p.z) + Rational(m[3]);
  return exact.to_double();
}

}  // namespace

Affine compose(const Affine& a, const Affine& b) {
  Affine c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      c[4 * i + j] = a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] + (j == 3 ? a[4 * i + 3] : 0.0);
  return c;
}

Point3 transformed(const Affine& m, const Point3& p) { return {row(&m[0], p), row(&m[4], p), row(&m[8], p)}; }

}  // namespace hsr::internal::read
