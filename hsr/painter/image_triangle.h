#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hsr/painter/face_pieces.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace hsr {

/// A triangle in the image in floats, its corners so that O is positive within. The last place is the third corner again: four
/// make a vector. Not a number: no triangle, or its image is not known.
struct alignas(16) ImageTriangle {
  std::array<float, 4> x, y;
  std::array<std::uint32_t, 4> vertex;
};

/// The images of the pieces that are triangles, moved and multiplied so that all fit into a square from -1 to 1.
struct ImageTriangles {
  std::vector<ImageTriangle> triangles;  // by piece; none: images are not known
  float error = 0;                       // of each coordinate
};

/// Cost: O(n), parallel.
ImageTriangles image_triangles(const Sight& sight, const FacePieces& pieces);

/// Whether a side of one triangle has nothing of the inside of another before it.
enum class Separation : std::uint8_t { yes, no, open };

/// Whether a side of a separates the images of a and b; open: floats leave one side open. The bound is that of ImageLine, with
/// the rounding of floats. Without branches: which test decides is not to be foreseen.
inline Separation separation(const ImageTriangle& a, const ImageTriangle& b, float error) {
  constexpr unsigned all = 15;
  constexpr float u = 0x1p-24F;
  bool is_separated = false, may_be = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    const float dx = a.x[next] - a.x[k], dy = a.y[next] - a.y[k], length = std::fabs(dx) + std::fabs(dy);
    const float least = 2.2F * error * length + 9.1F * error * error + 0x1p-100F, slope = 2.2F * error + 4.2F * u * length;
    unsigned before = 0, behind = 0, on = 0;  // bit i: certainly for corner i of b; it is an end of the side
#if defined(__SSE2__)
    const __m128 sign = _mm_set1_ps(-0.0F);
    const __m128 rx = _mm_sub_ps(_mm_load_ps(b.x.data()), _mm_set1_ps(a.x[k]));
    const __m128 ry = _mm_sub_ps(_mm_load_ps(b.y.data()), _mm_set1_ps(a.y[k]));
    const __m128 det = _mm_sub_ps(_mm_mul_ps(_mm_set1_ps(dx), ry), _mm_mul_ps(_mm_set1_ps(dy), rx));
    const __m128 size = _mm_add_ps(_mm_andnot_ps(sign, rx), _mm_andnot_ps(sign, ry));
    const __m128 bound = _mm_add_ps(_mm_set1_ps(least), _mm_mul_ps(_mm_set1_ps(slope), size));
    before = static_cast<unsigned>(_mm_movemask_ps(_mm_cmpgt_ps(det, bound)));
    behind = static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(det, _mm_xor_ps(bound, sign))));
    const __m128i corners = _mm_load_si128(reinterpret_cast<const __m128i*>(b.vertex.data()));
    const auto is = [&](std::uint32_t v) { return _mm_cmpeq_epi32(corners, _mm_set1_epi32(static_cast<int>(v))); };
    on = static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_or_si128(is(a.vertex[k]), is(a.vertex[next])))));
#else
    for (unsigned i = 0; i < 4; ++i) {
      const float rx = b.x[i] - a.x[k], ry = b.y[i] - a.y[k], det = dx * ry - dy * rx;
      const float bound = least + slope * (std::fabs(rx) + std::fabs(ry));
      before |= unsigned{det > bound} << i;
      behind |= unsigned{det < -bound} << i;
      on |= unsigned{(b.vertex[i] == a.vertex[k]) | (b.vertex[i] == a.vertex[next])} << i;
    }
#endif
    is_separated |= (behind | on) == all;
    may_be |= (before & ~on) == 0;
  }
  return is_separated ? Separation::yes : may_be ? Separation::open : Separation::no;
}

}  // namespace hsr
