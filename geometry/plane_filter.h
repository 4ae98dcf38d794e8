#pragma once

#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/plane.h"
#include "geometry/predicates.h"

namespace hsr {

/// A plane prepared for many points: its coefficients in doubles, with a proven bound of the error they cause.
///
/// value(p) = n . (p - o) + offset, and |value - exact| <= slope (|dx| + |dy| + |dz|) + least, where d = p - o as computed.
/// For a span, with u = 2^-53 and A_x = |u_y v_z| + |u_z v_y| (and so on) over the exact differences:
///   each computed difference carries (1 + u), so n_x errs by at most 4.1 u A_x; d by u |d|; the three products and two sums of
///   the dot product by at most 3.1 u sum |n_i d_i|; together 8.3 u sum A_i |d_i|. The A that is computed is at least
///   (1 - 4u) A, and the sum of |d_i| at least (1 - 3u) of it; hence slope = 10 u max A_i.
///   Underflow: with all numbers below 2^100, lost products change the value by less than 2^-960; hence least = 2^-900.
/// The other kinds take slope and offset from ErrorBounded arithmetic.
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
};

}  // namespace hsr
