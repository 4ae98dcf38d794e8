#pragma once

#include <gmpxx.h>

#include "geometry/number.h"
#include "geometry/point.h"

namespace hsr::oracle {

/// The oracle's only number. Always written out as `Q x = ...`, never `auto`: gmpxx expressions dangle.
using Q = mpq_class;

inline Q exact(const Rational& x) { return Q(x.get()); }

struct Vec {
  Q x, y, z;

  Vec() = default;
  Vec(Q a, Q b, Q c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  explicit Vec(const Point3& p) : x(p.x), y(p.y), z(p.z) {}

  const Q& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(const Q& s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend bool operator==(const Vec& a, const Vec& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

inline Q dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline bool is_zero(const Vec& a) { return sgn(a.x) == 0 && sgn(a.y) == 0 && sgn(a.z) == 0; }

}  // namespace hsr::oracle
