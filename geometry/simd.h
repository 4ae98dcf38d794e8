#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// A few numbers that are computed with at once. Each operation rounds as that of single numbers, so results are the same bits
// with and without vectors. Code uses FourFloats, TwoDoubles and FourIndices; the test compares both kinds of each.

namespace hsr::internal::simd {

/// n numbers, one by one: for every processor. What a comparison gives is a mask in each place, of all bits or none.
template <class T, std::size_t n>
struct Lanes {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  static constexpr Bits sign = Bits{1} << (8 * sizeof(T) - 1);

  std::array<T, n> v;

  template <class F>
  static Lanes each(const F& at) {
    Lanes x;
    for (std::size_t k = 0; k < n; ++k) x.v[k] = at(k);
    return x;
  }
  static Bits bits_of(T x) { return std::bit_cast<Bits>(x); }
  static T mask(bool is_set) { return std::bit_cast<T>(is_set ? static_cast<Bits>(~Bits{0}) : Bits{0}); }

  static Lanes all(T x) {
    return each([&](std::size_t) { return x; });
  }
  static Lanes zero() { return all(T{0}); }
  /// @pre aligned to 16 bytes
  static Lanes load(const T* x) {
    return each([&](std::size_t k) { return x[k]; });
  }
  void store(T* x) const {
    for (std::size_t k = 0; k < n; ++k) x[k] = v[k];
  }
  T operator[](std::size_t k) const { return v[k]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return a.v[k] + b.v[k]; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return a.v[k] - b.v[k]; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return a.v[k] * b.v[k]; });
  }
  friend Lanes operator-(const Lanes& a) {
    return each([&](std::size_t k) { return -a.v[k]; });
  }
  friend Lanes operator>(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return mask(a.v[k] > b.v[k]); });
  }
  friend Lanes operator>=(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return mask(a.v[k] >= b.v[k]); });
  }
  friend Lanes operator<(const Lanes& a, const Lanes& b) { return b > a; }
  friend Lanes operator<=(const Lanes& a, const Lanes& b) { return b >= a; }
  friend Lanes operator|(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return std::bit_cast<T>(bits_of(a.v[k]) | bits_of(b.v[k])); });
  }
  friend Lanes operator&(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t k) { return std::bit_cast<T>(bits_of(a.v[k]) & bits_of(b.v[k])); });
  }
  /// Zero where the mask is set.
  Lanes without(const Lanes& mask) const {
    return each([&](std::size_t k) { return std::bit_cast<T>(bits_of(v[k]) & ~bits_of(mask.v[k])); });
  }
  Lanes magnitude() const {
    return each([&](std::size_t k) { return std::bit_cast<T>(bits_of(v[k]) & ~sign); });
  }
  /// The places 1, 2, 0 and 3.
  Lanes turned() const requires(n == 4) { return {{v[1], v[2], v[0], v[3]}}; }
  /// Bit k: place k is a mask of all bits, or negative.
  unsigned bits() const {
    unsigned all = 0;
    for (unsigned k = 0; k < n; ++k) all |= ((bits_of(v[k]) & sign) != 0 ? 1U : 0U) << k;
    return all;
  }
};

/// Masks.
template <std::size_t n>
Lanes<float, n> operator==(const Lanes<std::uint32_t, n>& a, const Lanes<std::uint32_t, n>& b) {
  return Lanes<float, n>::each([&](std::size_t k) { return Lanes<float, n>::mask(a.v[k] == b.v[k]); });
}

#if defined(__SSE2__)

/// Lanes<float, 4> in one register.
struct FloatVector {
  __m128 v;

  static FloatVector all(float x) { return {_mm_set1_ps(x)}; }
  static FloatVector zero() { return {_mm_setzero_ps()}; }
  static FloatVector load(const float* x) { return {_mm_load_ps(x)}; }
  void store(float* x) const { _mm_store_ps(x, v); }
  float operator[](std::size_t k) const { return v[k]; }

  friend FloatVector operator+(FloatVector a, FloatVector b) { return {_mm_add_ps(a.v, b.v)}; }
  friend FloatVector operator-(FloatVector a, FloatVector b) { return {_mm_sub_ps(a.v, b.v)}; }
  friend FloatVector operator*(FloatVector a, FloatVector b) { return {_mm_mul_ps(a.v, b.v)}; }
  friend FloatVector operator-(FloatVector a) { return {_mm_xor_ps(_mm_set1_ps(-0.0F), a.v)}; }
  friend FloatVector operator>(FloatVector a, FloatVector b) { return {_mm_cmpgt_ps(a.v, b.v)}; }
  friend FloatVector operator>=(FloatVector a, FloatVector b) { return {_mm_cmpge_ps(a.v, b.v)}; }
  friend FloatVector operator<(FloatVector a, FloatVector b) { return {_mm_cmplt_ps(a.v, b.v)}; }
  friend FloatVector operator<=(FloatVector a, FloatVector b) { return {_mm_cmple_ps(a.v, b.v)}; }
  friend FloatVector operator|(FloatVector a, FloatVector b) { return {_mm_or_ps(a.v, b.v)}; }
  friend FloatVector operator&(FloatVector a, FloatVector b) { return {_mm_and_ps(a.v, b.v)}; }
  FloatVector without(FloatVector mask) const { return {_mm_andnot_ps(mask.v, v)}; }
  FloatVector magnitude() const { return {_mm_andnot_ps(_mm_set1_ps(-0.0F), v)}; }
  FloatVector turned() const { return {_mm_shuffle_ps(v, v, _MM_SHUFFLE(3, 0, 2, 1))}; }
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_ps(v)); }
};

/// Lanes<double, 2> in one register.
struct DoubleVector {
  __m128d v;

  static DoubleVector all(double x) { return {_mm_set1_pd(x)}; }
  static DoubleVector zero() { return {_mm_setzero_pd()}; }
  static DoubleVector load(const double* x) { return {_mm_load_pd(x)}; }
  void store(double* x) const { _mm_store_pd(x, v); }
  double operator[](std::size_t k) const { return v[k]; }

  friend DoubleVector operator+(DoubleVector a, DoubleVector b) { return {_mm_add_pd(a.v, b.v)}; }
  friend DoubleVector operator-(DoubleVector a, DoubleVector b) { return {_mm_sub_pd(a.v, b.v)}; }
  friend DoubleVector operator*(DoubleVector a, DoubleVector b) { return {_mm_mul_pd(a.v, b.v)}; }
  friend DoubleVector operator-(DoubleVector a) { return {_mm_xor_pd(_mm_set1_pd(-0.0), a.v)}; }
  friend DoubleVector operator>(DoubleVector a, DoubleVector b) { return {_mm_cmpgt_pd(a.v, b.v)}; }
  friend DoubleVector operator>=(DoubleVector a, DoubleVector b) { return {_mm_cmpge_pd(a.v, b.v)}; }
  friend DoubleVector operator<(DoubleVector a, DoubleVector b) { return {_mm_cmplt_pd(a.v, b.v)}; }
  friend DoubleVector operator<=(DoubleVector a, DoubleVector b) { return {_mm_cmple_pd(a.v, b.v)}; }
  friend DoubleVector operator|(DoubleVector a, DoubleVector b) { return {_mm_or_pd(a.v, b.v)}; }
  friend DoubleVector operator&(DoubleVector a, DoubleVector b) { return {_mm_and_pd(a.v, b.v)}; }
  DoubleVector without(DoubleVector mask) const { return {_mm_andnot_pd(mask.v, v)}; }
  DoubleVector magnitude() const { return {_mm_andnot_pd(_mm_set1_pd(-0.0), v)}; }
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_pd(v)); }
};

/// Lanes<std::uint32_t, 4> in one register.
struct IndexVector {
  __m128i v;

  static IndexVector all(std::uint32_t x) { return {_mm_set1_epi32(static_cast<int>(x))}; }
  static IndexVector load(const std::uint32_t* x) { return {_mm_load_si128(reinterpret_cast<const __m128i*>(x))}; }
  void store(std::uint32_t* x) const { _mm_store_si128(reinterpret_cast<__m128i*>(x), v); }
  IndexVector turned() const { return {_mm_shuffle_epi32(v, _MM_SHUFFLE(3, 0, 2, 1))}; }
  friend FloatVector operator==(IndexVector a, IndexVector b) { return {_mm_castsi128_ps(_mm_cmpeq_epi32(a.v, b.v))}; }
};

#endif

}  // namespace hsr::internal::simd

namespace hsr::internal {

#if defined(__SSE2__)
using FourFloats = simd::FloatVector;
using TwoDoubles = simd::DoubleVector;
using FourIndices = simd::IndexVector;
#else
using FourFloats = simd::Lanes<float, 4>;
using TwoDoubles = simd::Lanes<double, 2>;
using FourIndices = simd::Lanes<std::uint32_t, 4>;
#endif

}  // namespace hsr::internal
