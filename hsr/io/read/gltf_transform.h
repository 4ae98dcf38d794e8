#pragma once

#include <array>

#include "geometry/point.h"

namespace hsr::internal::read {

/// An affine map, row by row: x' = m[0] x + m[1] y + m[2] z + m[3], and so on.
using Affine = std::array<double, 12>;

inline constexpr Affine identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

/// Scaled, then turned by a quaternion (x, y, z, w), then moved. @param is_exact set to false if a number is rounded
Affine placement(const Point3& translation, const std::array<double, 4>& rotation, const Point3& scale, bool& is_exact);

/// First `b`, then `a`: each number computed in doubles, in the order written. @param is_exact set to false if one is rounded
Affine compose(const Affine& a, const Affine& b, bool& is_exact);

/// `p` mapped: each coordinate is the exact value of its row, rounded once to the nearest double (an infinity beyond the
/// largest). Exact: yes. Source: the check whether a rounding is safe is Ziv's, 1991; otherwise rationals decide.
/// @param is_exact set to false if a coordinate is rounded
Point3 transformed(const Affine& m, const Point3& p, bool& is_exact);

}  // namespace hsr::internal::read
