#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace hsr {

/// Four floats, or four masks of all bits or none, at once. Each operation rounds as that of single floats.
struct FourFloats {
#if defined(__SSE2__)
  __m128 v;

  static FourFloats all(float x) { return {_mm_set1_ps(x)}; }
  static FourFloats no() { return {_mm_setzero_ps()}; }
  /// @pre aligned to 16 bytes
  static FourFloats of(const std::array<float, 4>& x) { return {_mm_load_ps(x.data())}; }
  friend FourFloats operator+(FourFloats a, FourFloats b) { return {_mm_add_ps(a.v, b.v)}; }
  friend FourFloats operator-(FourFloats a, FourFloats b) { return {_mm_sub_ps(a.v, b.v)}; }
  friend FourFloats operator*(FourFloats a, FourFloats b) { return {_mm_mul_ps(a.v, b.v)}; }
  friend FourFloats operator>(FourFloats a, FourFloats b) { return {_mm_cmpgt_ps(a.v, b.v)}; }
  friend FourFloats operator|(FourFloats a, FourFloats b) { return {_mm_or_ps(a.v, b.v)}; }
  friend FourFloats operator&(FourFloats a, FourFloats b) { return {_mm_and_ps(a.v, b.v)}; }
  FourFloats without(FourFloats mask) const { return {_mm_andnot_ps(mask.v, v)}; }
  FourFloats magnitude() const { return {_mm_andnot_ps(_mm_set1_ps(-0.0F), v)}; }
  /// The places 1, 2, 0 and 3.
  FourFloats turned() const { return {_mm_shuffle_ps(v, v, _MM_SHUFFLE(3, 0, 2, 1))}; }
  /// @pre aligned to 16 bytes
  void store(std::array<float, 4>& x) const { _mm_store_ps(x.data(), v); }
  /// Bit k: place k is a mask of all bits.
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_ps(v)); }
#else
  std::array<float, 4> v;

  template <class F>
  static FourFloats each(const F& at) {
    return {{at(0), at(1), at(2), at(3)}};
  }
  static float mask(bool is_set) { return is_set ? 1.0F : 0.0F; }
  static FourFloats all(float x) { return {{x, x, x, x}}; }
  static FourFloats no() { return all(0); }
  static FourFloats of(const std::array<float, 4>& x) { return {x}; }
  friend FourFloats operator+(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return a.v[k] + b.v[k]; });
  }
  friend FourFloats operator-(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return a.v[k] - b.v[k]; });
  }
  friend FourFloats operator*(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return a.v[k] * b.v[k]; });
  }
  friend FourFloats operator>(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return mask(a.v[k] > b.v[k]); });
  }
  friend FourFloats operator|(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return mask(a.v[k] != 0 || b.v[k] != 0); });
  }
  friend FourFloats operator&(FourFloats a, FourFloats b) {
    return each([&](std::size_t k) { return mask(a.v[k] != 0 && b.v[k] != 0); });
  }
  FourFloats without(FourFloats other) const {
    return each([&](std::size_t k) { return mask(v[k] != 0 && other.v[k] == 0); });
  }
  FourFloats magnitude() const {
    return each([&](std::size_t k) { return std::fabs(v[k]); });
  }
  FourFloats turned() const { return {{v[1], v[2], v[0], v[3]}}; }
  void store(std::array<float, 4>& x) const { x = v; }
  unsigned bits() const {
    return unsigned{v[0] != 0} | unsigned{v[1] != 0} << 1U | unsigned{v[2] != 0} << 2U | unsigned{v[3] != 0} << 3U;
  }
#endif
};

/// Four indices at once.
struct FourIndices {
#if defined(__SSE2__)
  __m128i v;

  static FourIndices all(std::uint32_t x) { return {_mm_set1_epi32(static_cast<int>(x))}; }
  /// @pre aligned to 16 bytes
  static FourIndices of(const std::array<std::uint32_t, 4>& x) {
    return {_mm_load_si128(reinterpret_cast<const __m128i*>(x.data()))};
  }
  FourIndices turned() const { return {_mm_shuffle_epi32(v, _MM_SHUFFLE(3, 0, 2, 1))}; }
  /// Masks.
  friend FourFloats operator==(FourIndices a, FourIndices b) { return {_mm_castsi128_ps(_mm_cmpeq_epi32(a.v, b.v))}; }
#else
  std::array<std::uint32_t, 4> v;

  static FourIndices all(std::uint32_t x) { return {{x, x, x, x}}; }
  static FourIndices of(const std::array<std::uint32_t, 4>& x) { return {x}; }
  FourIndices turned() const { return {{v[1], v[2], v[0], v[3]}}; }
  friend FourFloats operator==(FourIndices a, FourIndices b) {
    return FourFloats::each([&](std::size_t k) { return FourFloats::mask(a.v[k] == b.v[k]); });
  }
#endif
};

}  // namespace hsr
