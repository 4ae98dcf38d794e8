#pragma once

#include <array>
#include <cmath>

#include "geometry/plane_filter.h"
#include "hsr/sight.h"

namespace hsr {

/// A triangle prepared for the many lines that it is asked about: its image, and its plane.
///
/// A determinant of image points that are known within E has the bound of ImageLine. What is not known is not a number, or has
/// an unbounded error, and decides nothing.
struct ImageFace {
  TriangleId triangle;
  std::array<VertexId, 3> corners;
  std::array<double, 3> x = {}, y = {};  ///< of the corners' images
  double facing = 0;                     ///< 1 or -1: times O, positive within
  PlaneFilter plane;
  ErrorBounded per_eye;  ///< -1 / plane(E), E the viewpoint: times plane(p), how far toward the viewer from p the plane is

  ImageFace() = default;
  ImageFace(const Sight& sight, TriangleId t)
      : triangle(t), corners(sight.mesh().triangles[t]), plane(sight.filter(sight.face_plane(t))) {
    const bool is_known = sight.image_error() < HUGE_VAL && sight.facing(t) != Sign::zero;
    facing = sight.facing(t) == Sign::positive ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const ImagePoint p = is_known ? sight.image(corners[k]) : ImagePoint{NAN, NAN};
      x[k] = p.x;
      y[k] = p.y;
    }
    const Point3& e = sight.eye().at;
    // The bound of a PlaneFilter at o + D is that of n . D.
    const ErrorBounded at_eye =
        sight.is_perspective() ? plane(e)
                               : ErrorBounded{plane.nx * e.x + plane.ny * e.y + plane.nz * e.z,
                                              plane.slope * (std::fabs(e.x) + std::fabs(e.y) + std::fabs(e.z)) + plane.least};
    per_eye = quotient({-1, 0}, at_eye);
  }

  bool has(VertexId v) const { return v == corners[0] || v == corners[1] || v == corners[2]; }

  /// Whether the triangle certainly lies on one side of the line through p and q. @param error of each coordinate of these
  /// points
  bool is_beside(const ImagePoint& p, const ImagePoint& q, double error) const {
    const double sx = q.x - p.x, sy = q.y - p.y, size = std::fabs(sx) + std::fabs(sy), per_length = 2.2 * error;
    const double least = 9.1 * error * error + 0x1p-1000 + per_length * size, slope = per_length + 4.2 * ErrorBounded::u * size;
    const auto side = [&](std::size_t k) {
      const double px = x[k] - p.x, py = y[k] - p.y;
      const double det = sx * py - sy * px, bound = least + slope * (std::fabs(px) + std::fabs(py));
      return det > bound ? 1 : det < -bound ? -1 : 0;
    };
    const int first = side(0);
    return first != 0 && side(1) == first && side(2) == first;
  }

  /// O of the side from corner k to the next for p, times facing, in the image. @param error of each coordinate of these points
  ErrorBounded at_side(unsigned k, const ImagePoint& p, double error) const {
    const unsigned next = k == 2 ? 0 : k + 1;
    const double dx = facing * (x[next] - x[k]), dy = facing * (y[next] - y[k]), length = std::fabs(dx) + std::fabs(dy);
    const double px = p.x - x[k], py = p.y - y[k];
    return {dx * py - dy * px, 9.1 * error * error + 0x1p-1000 + 2.2 * error * length +
                                   (2.2 * error + 4.2 * ErrorBounded::u * length) * (std::fabs(px) + std::fabs(py))};
  }

  /// What the image tells for certain of the triangle and a segment.
  struct Overlap {
    bool is_none = false;    ///< both ends lie strictly beyond one of its sides
    unsigned is_within = 0;  ///< bit k: both ends are strictly on the inner side of the triangle's side k
    std::array<ErrorBounded, 3> at_p = {}, at_q = {};  ///< O of side k for the ends, times facing, in the image
  };
  /// Of the segment from p to q. @param error of each coordinate of these points
  Overlap overlap(const ImagePoint& p, const ImagePoint& q, double error) const {
    Overlap overlap;
    for (unsigned k = 0; k < 3; ++k) {
      const ErrorBounded at_p = overlap.at_p[k] = at_side(k, p, error), at_q = overlap.at_q[k] = at_side(k, q, error);
      if (at_p.value < -at_p.error && at_q.value < -at_q.error) {
        overlap.is_none = true;
        return overlap;
      }
      overlap.is_within |= (unsigned{at_p.value > at_p.error} & unsigned{at_q.value > at_q.error}) << k;
    }
    return overlap;
  }
};

}  // namespace hsr
