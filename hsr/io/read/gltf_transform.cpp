#include "hsr/io/read/gltf_transform.h"

#include <cmath>

#include "geometry/number.h"

namespace hsr::internal::read {

namespace {

double row(const double* m, const Point3& p, bool& is_exact) {
  const double terms[4][2] = {{m[0], p.x}, {m[1], p.y}, {m[2], p.z}, {m[3], 1}};
  // The sum in twice the precision: every product and sum is split into a double and its error, errors are summed in doubles.
  double sum = 0, low = 0, magnitude = 0;
  bool in_range = true, has_errors = false;
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
    has_errors = has_errors || product_error != 0 || sum_error != 0;
    magnitude += std::abs(product);
  }
  if (magnitude == 0) return 0;
  if (in_range) {
    // The errors are below 2^-52 of the magnitude each, and there are fewer than 16 roundings of them: 2^-53 * 2^-52 * 2^7.
    const double bound = magnitude * 0x1p-98;
    const double high = sum + (low + bound);
    // Errors may cancel: only rationals tell, and are asked no more once a number is known to be rounded.
    if (high == sum + (low - bound) && high != 0 && !(has_errors && is_exact)) return high;
  }
  const Rational exact =
      Rational(m[0]) * Rational(p.x) + Rational(m[1]) * Rational(p.y) + Rational(m[2]) * Rational(p.z) + Rational(m[3]);
  const double rounded = exact.to_double();
  is_exact = is_exact && std::isfinite(rounded) && Rational(rounded) == exact;
  return rounded;
}

}  // namespace

Affine placement(const Point3& translation, const std::array<double, 4>& rotation, const Point3& scale, bool& is_exact) {
  const auto [x, y, z, w] = rotation;
  Affine m = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     translation.x,
              2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     translation.y,
              2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), translation.z};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[4 * i + j] *= scale[static_cast<int>(j)];
  if (is_exact && (x != 0 || y != 0 || z != 0) && std::isfinite(x + y + z + w + scale.x + scale.y + scale.z)) {
    const Rational qx(x), qy(y), qz(z), qw(w), one(1.0), two(2.0);
    const std::array<Rational, 9> r = {
        one - two * (qy * qy + qz * qz), two * (qx * qy - qz * qw),       two * (qx * qz + qy * qw),
        two * (qx * qy + qz * qw),       one - two * (qx * qx + qz * qz), two * (qy * qz - qx * qw),
        two * (qx * qz - qy * qw),       two * (qy * qz + qx * qw),       one - two * (qx * qx + qy * qy)};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Rational exact = r[3 * i + j] * Rational(scale[static_cast<int>(j)]);
        is_exact = is_exact && std::isfinite(m[4 * i + j]) && Rational(m[4 * i + j]) == exact;
      }
  }
  return m;
}

Affine compose(const Affine& a, const Affine& b, bool& is_exact) {
  Affine c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      c[4 * i + j] = a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] + (j == 3 ? a[4 * i + 3] : 0.0);
  for (std::size_t k = 0; is_exact && k < c.size(); ++k) {
    const std::size_t i = k / 4 * 4, j = k % 4;
    if (!std::isfinite(c[k])) return c;  // it is refused, or its coordinates are
    const Rational exact = Rational(a[i]) * Rational(b[j]) + Rational(a[i + 1]) * Rational(b[4 + j]) +
                           Rational(a[i + 2]) * Rational(b[8 + j]) + Rational(j == 3 ? a[i + 3] : 0.0);
    is_exact = Rational(c[k]) == exact;
  }
  return c;
}

Point3 transformed(const Affine& m, const Point3& p, bool& is_exact) {
  return {row(&m[0], p, is_exact), row(&m[4], p, is_exact), row(&m[8], p, is_exact)};
}

}  // namespace hsr::internal::read
