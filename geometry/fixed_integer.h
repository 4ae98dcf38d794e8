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
  std::array<std::uint64_t, L> limbs_;
};

using hsr::sign_of;
template <std::size_t L>
Sign sign_of(const FixedInteger<L>& x) {
  return x.sign();
}

}  // namespace hsr::internal
