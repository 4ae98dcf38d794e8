#pragma once

#include "geometry/point.h"

namespace hsr {

/// An arc of an ellipse on the paper: centre + cos t long_axis + sin t short_axis for t between `from` and `to`. Millimetres, y down.
///
///   (1) the axes are half of those of the ellipse and at right angles, the longer one first: t grows from x to y
///   (2) of a circle they are (r, 0) and (0, r), exactly
///   (3) `to` is less than `from` where the arc runs the other way; they are 2 pi apart in a whole ellipse, and less in all others
struct EllipseArc {
  Point2 centre = {}, long_axis = {}, short_axis = {};
  double from = 0, to = 0;

  Point2 at(double t) const;
  /// Of the point of the ellipse in the direction of p, where the ellipse is seen as a circle; between -pi and pi.
  double parameter_of(const Point2& p) const;
  double long_radius() const;
  double short_radius() const;
  double sweep() const { return to - from; }
  bool is_circle() const { return long_axis.y == 0 && long_axis.x == short_axis.y; }
  bool is_whole() const;
};

}  // namespace hsr
