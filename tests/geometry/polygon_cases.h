#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "geometry/index.h"
#include "geometry/number.h"
#include "geometry/point.h"

/// Polygons for tests, and the dumbest correct answers about them, in rationals.
namespace hsr::test {

using Points = IndexedVector<VertexId, Point3>;
using Ring = std::vector<VertexId>;
using Vector = std::array<Rational, 3>;

inline Ring ring(std::initializer_list<std::size_t> corners) {
  Ring r;
  for (const std::size_t c : corners) r.emplace_back(c);
  return r;
}

/// Twice the area vector: the exact Newell normal.
inline Vector newell(const Points& points, std::span<const VertexId> polygon) {
  Vector sum;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point3 &p = points[polygon[k]], &q = points[polygon[(k + 1) % polygon.size()]];
    for (int axis = 0; axis < 3; ++axis) {
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      sum[static_cast<std::size_t>(axis)] =
          sum[static_cast<std::size_t>(axis)] + Rational(p[i]) * Rational(q[j]) - Rational(p[j]) * Rational(q[i]);
    }
  }
  return sum;
}

inline Sign dot_sign(const Vector& a, const Vector& b) { return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).sign(); }

/// The orientation of three points of the xy plane.
inline Sign turn(const Point3& a, const Point3& b, const Point3& c) {
  return ((Rational(b.x) - a.x) * (Rational(c.y) - a.y) - (Rational(b.y) - a.y) * (Rational(c.x) - a.x)).sign();
}

inline bool in_closed_triangle(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return turn(a, b, p) != Sign::negative && turn(b, c, p) != Sign::negative && turn(c, a, p) != Sign::negative;
}

/// Whether two closed segments of the xy plane have a point in common.
inline bool touch(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto on = [](const Point3& p, const Point3& q, const Point3& r) {
    return turn(p, q, r) == Sign::zero && std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
  return turn(a, b, c) * turn(a, b, d) == Sign::negative && turn(c, d, a) * turn(c, d, b) == Sign::negative;
}

/// Whether a polygon in the xy plane touches itself nowhere but where neighbours meet.
inline bool is_simple(const Points& points, const Ring& r) {
  const std::size_t n = r.size();
  const auto at = [&](std::size_t k) { return points[r[k % n]]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 &a = at(i), &b = at(i + 1), &c = at(i + 2);
    if (a == b) return false;
    if (turn(a, b, c) == Sign::zero &&
        (Rational(a.x) - b.x) * (Rational(c.x) - b.x) + (Rational(a.y) - b.y) * (Rational(c.y) - b.y) > 0)
      return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && touch(a, b, at(j), at(j + 1))) return false;
  }
  return true;
}

/// How often a polygon in the xy plane runs around a point that is on no edge.
inline int winding_number(const Points& points, const Ring& r, const Point3& p) {
  int number = 0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    const Point3 &a = points[r[k]], &b = points[r[(k + 1) % r.size()]];
    if (a.y <= p.y && b.y > p.y && turn(a, b, p) == Sign::positive) ++number;
    if (a.y > p.y && b.y <= p.y && turn(a, b, p) == Sign::negative) --number;
  }
  return number;
}

/// Ears cut off one by one, always the lowest: what geometry/triangulate.h says of simple polygons, word by word.
/// @pre simple, in the xy plane, counter-clockwise
inline std::vector<std::array<VertexId, 3>> lowest_ears(const Points& points, Ring r) {
  std::vector<std::array<VertexId, 3>> ears;
  while (r.size() >= 3) {
    const std::size_t n = r.size();
    std::size_t best = n;
    for (std::size_t k = 0; k < n; ++k) {
      const VertexId a = r[(k + n - 1) % n], b = r[k], c = r[(k + 1) % n];
      if (turn(points[a], points[b], points[c]) != Sign::positive) continue;
      const bool is_ear = std::none_of(r.begin(), r.end(), [&](VertexId v) {
        return v != a && v != b && v != c && in_closed_triangle(points[a], points[b], points[c], points[v]);
      });
      if (is_ear && (best == n || b < r[best])) best = k;
    }
    if (best == n) return {};
    ears.push_back({r[(best + n - 1) % n], r[best], r[(best + 1) % n]});
    r.erase(r.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return ears;
}

/// `corners` points of the grid size x size in random order; they may coincide, the polygon may be anything.
inline Points grid_polygon(std::mt19937& random, int corners, int size) {
  std::uniform_int_distribution<int> coordinate(0, size - 1);
  Points points;
  for (int k = 0; k < corners; ++k) points.push_back({double(coordinate(random)), double(coordinate(random)), 0});
  return points;
}

/// A simple polygon around the origin, in the xy plane, counter-clockwise: `ring` visits the points in random index order.
inline std::pair<Points, Ring> star_polygon(std::mt19937& random, int corners) {
  std::uniform_int_distribution<int> coordinate(-40, 40);
  std::vector<Point3> p;
  const auto upper = [](const Point3& q) { return q.y > 0 || (q.y == 0 && q.x > 0); };
  while (static_cast<int>(p.size()) < corners) {
    const Point3 q{double(coordinate(random)), double(coordinate(random)), 0};
    if (q == Point3{}) continue;
    const bool same_ray =
        std::any_of(p.begin(), p.end(), [&](const Point3& o) { return upper(o) == upper(q) && o.x * q.y == o.y * q.x; });
    if (!same_ray) p.push_back(q);
  }
  std::sort(p.begin(), p.end(),
            [&](const Point3& a, const Point3& b) { return upper(a) != upper(b) ? upper(a) : a.x * b.y - a.y * b.x > 0; });
  std::vector<std::size_t> index(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) index[k] = k;
  std::shuffle(index.begin(), index.end(), random);
  Points points(p.size());
  Ring r;
  for (std::size_t k = 0; k < p.size(); ++k) {
    points[VertexId(index[k])] = p[k];
    r.emplace_back(index[k]);
  }
  return {points, r};
}

}  // namespace hsr::test
