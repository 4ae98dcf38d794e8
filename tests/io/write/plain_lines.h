#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/point.h"

namespace hsr {

inline double distance(const Point2& p, const Point2& a, const Point2& b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double t = square == 0 ? 0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

struct PlainLine {
  Point2 a, b;
  bool is_hidden;
};

inline bool is_on_one(const Point2& p, const std::vector<PlainLine>& lines, bool is_hidden, double within) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const PlainLine& l) { return l.is_hidden == is_hidden && distance(p, l.a, l.b) < within; });
}

/// Points of the one drawing that are not on the other.
inline int strays(const std::vector<PlainLine>& lines, const std::vector<PlainLine>& others, double within) {
  int count = 0;
  for (const PlainLine& l : lines)
    for (const double t : {0.01, 0.3, 0.5, 0.7, 0.99}) {
      const Point2 p = {l.a.x + t * (l.b.x - l.a.x), l.a.y + t * (l.b.y - l.a.y)};
      if (!is_on_one(p, others, l.is_hidden, within)) ++count;
    }
  return count;
}

}  // namespace hsr
