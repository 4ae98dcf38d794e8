#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/point.h"

// Vectors in doubles, each operation rounded as it is written. What is decided with them needs a bound of its own.

namespace hsr::internal {

inline Point3 plus(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
/// a + t b
inline Point3 sum(const Point3& a, double t, const Point3& b) { return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z}; }
inline Point3 over(const Point3& a, double divisor) { return {a.x / divisor, a.y / divisor, a.z / divisor}; }
inline double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The sum of the magnitudes of its entries, and the largest of them.
inline double norm_one(const Point3& a) { return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z); }
inline double norm_max(const Point3& a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }
/// Of length 1; zero stays zero. Its largest entry is brought to 1 first, so that nothing overflows or is lost.
inline Point3 unit(const Point3& a) {
  const double most = norm_max(a);
  if (!(most > 0)) return {0, 0, 0};
  const Point3 b = over(a, most);
  return over(b, std::sqrt(dot(b, b)));
}

}  // namespace hsr::internal
