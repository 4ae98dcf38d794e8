#pragma once

#include <algorithm>
#include <cmath>

#include "hsr/drawing/ellipse_arc.h"
#include "hsr/drawing/page.h"

namespace hsr {

inline Point2 millimetres(const PaperPoint& p) { return {double(p.x) / 1000, double(p.y) / 1000}; }
inline double distance(const Point2& p, const Point2& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Of a point from an arc, by looking all along it, then nearer and nearer to where it is least.
inline double distance(const Point2& p, const EllipseArc& arc) {
  double middle = (arc.from + arc.to) / 2, half = std::fabs(arc.sweep()) / 2, least = HUGE_VAL;
  for (int pass = 0; pass < 5; ++pass, half /= 20) {
    const double around = middle;
    const int steps = pass == 0 ? 200 : 40;
    for (int k = -steps; k <= steps; ++k) {
      const double t = std::clamp(around + k * half / steps, std::min(arc.from, arc.to), std::max(arc.from, arc.to));
      if (distance(p, arc.at(t)) >= least) continue;
      least = distance(p, arc.at(t));
      middle = t;
    }
  }
  return least;
}

}  // namespace hsr
