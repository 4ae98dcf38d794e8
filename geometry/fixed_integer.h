#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "geometry/number.h"

namespace hsr::internal {

/// A signed integer of 64 L bits, two's complement. Sums and products wrap, so a polynomial is right whenever its final value
/// fits, whatever its terms do. No allocation.
template <std::size_t L>
class FixedInteger {
 public:
  FixedInteger() = default;
  explicit FixedInteger(std::int64_t x) {
    limbs_[0] = static_cast<std::uint64_t>(x);
    for (std::size_t i = 1; i < L; ++i) limbs_[i] = x < 0 ? ~0ULL : 0;
  }
  explicit FixedInteger(__int128 x) {
    limbs_[0] = static_cast<std::uint64_t>(x);
    if constexpr (L > 1) limbs_[1] = static_cast<std::uint64_t>(x >> 64);
    for (std::size_t i = 2; i < L; ++i) limbs_[i] = x < 0 ? ~0ULL : 0;
  }
  template <std::size_t M>
  explicit FixedInteger(const FixedInteger<M>& x) {
    for (std::size_t i = 0; i < L; ++i) limbs_[i] = i < M ? x.limb(i) : x.is_negative() ? ~0ULL : 0;
  }

  /// x / 2^lowest. @pre x is a multiple of 2^lowest, and the quotient fits
  static FixedInteger from_double(double x, int lowest) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<int>((pattern >> 52) & 0x7ff);
    std::uint64_t mantissa = pattern & 0xfffffffffffffULL;
    if (exponent != 0) mantissa |= 1ULL << 52;
    if (mantissa == 0) return FixedInteger(std::int64_t{0});
    const int shift = (exponent == 0 ? 1 : exponent) - 1075 - lowest;
    FixedInteger r(std::int64_t{0});
    if (shift <= 0) {
      r.limbs_[0] = mantissa >> -shift;
    } else {
      const std::size_t limb = static_cast<std::size_t>(shift) / 64, bit = static_cast<std::size_t>(shift) % 64;
      r.limbs_[limb] = mantissa << bit;
      if (bit > 11 && limb + 1 < L) r.limbs_[limb + 1] = mantissa >> (64 - bit);
    }
    return (pattern >> 63) != 0 ? -r : r;
  }

  /// x / 2^lowest - y / 2^lowest. @pre as of from_double
  static FixedInteger difference(double x, double y, int lowest) {
    const int most = lowest + 1075 + 70;  // exponents up to which 53 bits, shifted, are within 124
    if (L >= 6 && exponent_of(x) <= most && exponent_of(y) <= most)
      return FixedInteger(narrow_from_double(x, lowest) - narrow_from_double(y, lowest));
    return from_double(x, lowest) - from_double(y, lowest);
  }

  std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  bool is_negative() const { return (limbs_[L - 1] >> 63) != 0; }
  Sign sign() const {
    if (is_negative()) return Sign::negative;
    std::uint64_t any = 0;
    for (const std::uint64_t x : limbs_) any |= x;
    return any != 0 ? Sign::positive : Sign::zero;
  }

  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger r;
    unsigned __int128 carry = 0;
    for (std::size_t i = 0; i < L; ++i) {
      carry += static_cast<unsigned __int128>(a.limbs_[i]) + b.limbs_[i];
      r.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return r;
  }
  friend FixedInteger operator-(const FixedInteger& a) {
    FixedInteger r;
    unsigned __int128 carry = 1;
    for (std::size_t i = 0; i < L; ++i) {
      carry += ~a.limbs_[i];
      r.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return r;
  }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) { return a + -b; }
  friend FixedInteger operator*(const FixedInteger& a, const FixedInteger& b) {
    if constexpr (L >= 6) return short_product(a, b);
    FixedInteger r;
    for (std::uint64_t& x : r.limbs_) x = 0;
    for (std::size_t i = 0; i < L; ++i) {
      unsigned __int128 carry = 0;
      for (std::size_t j = 0; i + j < L; ++j) {
        carry += static_cast<unsigned __int128>(a.limbs_[i]) * b.limbs_[j] + r.limbs_[i + j];
        r.limbs_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return r;
  }

 private:
  static int exponent_of(double x) { return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff); }
  /// x / 2^lowest. @pre as of from_double, and the exponent is at most 70 above lowest's
  static __int128 narrow_from_double(double x, int lowest) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const int exponent = exponent_of(x);
    std::uint64_t mantissa = pattern & 0xfffffffffffffULL;
    if (exponent != 0) mantissa |= 1ULL << 52;
    if (mantissa == 0) return 0;
    const int shift = (exponent == 0 ? 1 : exponent) - 1075 - lowest;
    const __int128 size = shift <= 0 ? __int128{mantissa >> -shift} : __int128{mantissa} << shift;
    return (pattern >> 63) != 0 ? -size : size;
  }
  /// How many limbs hold the number, its sign included: those above repeat the sign. At least 1.
  std::size_t length() const {
    const std::uint64_t sign = is_negative() ? ~0ULL : 0;
    std::size_t n = L;
    while (n > 1 && limbs_[n - 1] == sign && (limbs_[n - 2] >> 63) == (sign & 1)) --n;
    return n;
  }
  /// Subtracts b from the limbs from `first` on.
  void subtract_at(std::size_t first, const FixedInteger& b) {
    unsigned __int128 carry = 1;
    for (std::size_t i = first; i < L; ++i) {
      carry += static_cast<unsigned __int128>(limbs_[i]) + ~b.limbs_[i - first];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  }
  /// The product by the limbs that hold the factors: most factors in a polynomial are much shorter than its value. A negative
  /// number of n limbs counts as 2^(64 n) too many, which is taken off.
  static FixedInteger short_product(const FixedInteger& a, const FixedInteger& b) {
    const std::size_t m = a.length(), n = b.length();
    FixedInteger r;
    for (std::uint64_t& x : r.limbs_) x = 0;
    for (std::size_t i = 0; i < m; ++i) {
      unsigned __int128 carry = 0;
      const std::size_t end = n < L - i ? n : L - i;
      for (std::size_t j = 0; j < end; ++j) {
        carry += static_cast<unsigned __int128>(a.limbs_[i]) * b.limbs_[j] + r.limbs_[i + j];
        r.limbs_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
      if (i + n < L) r.limbs_[i + n] = static_cast<std::uint64_t>(carry);
    }
    // (a + 2^64m) (b + 2^64n) = a b + 2^64m b + 2^64n a + 2^64(m + n)
    if (a.is_negative()) r.subtract_at(m, b);
    if (b.is_negative()) r.subtract_at(n, a);
    if (a.is_negative() && b.is_negative()) r.subtract_at(m + n, FixedInteger(std::int64_t{1}));
    return r;
  }

  std::array<std::uint64_t, L> limbs_;
};

using hsr::sign_of;
template <std::size_t L>
Sign sign_of(const FixedInteger<L>& x) {
  return x.sign();
}

}  // namespace hsr::internal
