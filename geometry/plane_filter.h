#pragma once

#include <cmath>

#include "geometry/bounded_point.h"
#include "geometry/error_bounded.h"
#include "geometry/plane.h"
#include "geometry/predicates.h"

namespace hsr::internal {

/// A plane prepared for many points: its coefficients in doubles, with a proven bound of the error they cause.
///
/// value(p) = n . (p - o) + offset, and |value - exact| <= slope (|dx| + |dy| + |dz|) + least, where d = p - o as computed.
/// For a span, with u = 2^-53 and A_x = |u_y v_z| + |u_z v_y| (and so on) over the exact differences:
///   each computed difference carries (1 + u), so n_x errs by at most 4.1 u A_x; d by u |d|; the three products and two sums of
///   the dot product by at most 3.1 u sum |n_i d_i|; together 8.3 u sum A_i |d_i|. The A that is computed is at least
///   (1 - 4u) A, and the sum of |d_i| at least (1 - 3u) of it; hence slope = 10 u max A_i.
///   Underflow: with all numbers below 2^100, lost products change the value by less than 2^-960; hence least = 2^-900.
/// The other kinds take slope and offset from ErrorBounded arithmetic.
///
/// At a point P that is known as p, within e in each coordinate, the exact value is that at p and n* . (P - p), where n* is the
/// exact normal. Each |n*_i| is at most |n_i| + slope, as slope bounds the error of each entry of n; so the value at P differs
/// from that at p by at most e (|nx| + |ny| + |nz| + 3 slope). The factor 1.01 pays for the roundings of that product. That of
/// its sum with the bound at p costs at most u of each; of the bound at p, slope pays for it with what it is above the error
/// (10 u for 8.3 u), and least for lost products.
/// @pre the coordinates of p are below 2^100 too, or nothing is claimed
struct PlaneFilter {
  double nx = 0, ny = 0, nz = 0, ox = 0, oy = 0, oz = 0;
  double offset = 0, slope = 0, least = 0;

  PlaneFilter() = default;
  /// @param arithmetic staged; double_only makes the bound zero, the others infinite
  PlaneFilter(const Plane& plane, Arithmetic arithmetic);

  ErrorBounded operator()(const Point3& p) const {
    const double dx = p.x - ox, dy = p.y - oy, dz = p.z - oz;
    return {nx * dx + ny * dy + nz * dz + offset, slope * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz)) + least};
  }
  /// The value at a point that is known within an error; an infinite error where that is infinite.
  ErrorBounded operator()(const BoundedPoint3& p) const {
    ErrorBounded x = (*this)(p.p);
    if (p.error > 0) x.error += spread() * p.error;
    return x;
  }
  /// How the value changes along d: the share of p - o in the proof, with a difference that is exact.
  ErrorBounded change(const Point3& d) const { return {dot({nx, ny, nz}, d), slope * norm_one(d) + least}; }
  /// What an error of 1 in each coordinate of a point adds to the bound of the value there.
  double spread() const { return (std::fabs(nx) + std::fabs(ny) + std::fabs(nz) + 3 * slope) * 1.01; }
};

}  // namespace hsr::internal
