#pragma once

#include <array>
#include <cmath>

#include "geometry/plane_filter.h"
#include "geometry/simd.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/segment_filter.h"

namespace hsr::internal {

/// A triangle prepared for the many lines that it is asked about: its image, and its plane.
///
/// A determinant of image points that are known within E has the bound of SegmentFilter. What is not known is not a number, or
/// has an unbounded error, and decides nothing.
struct TriangleFilter {
  TriangleId triangle;
  std::array<VertexId, 3> corners;
  std::array<double, 3> x = {}, y = {};  ///< of the corners' images
  double facing = 0;                     ///< ProjectedMesh::facing, 1 or -1: times O of its sides, positive within
  PlaneFilter plane;
  ErrorBounded per_eye;  ///< -1 / plane(E), E the viewpoint: times plane(p), how far toward the viewer from p the plane is

  TriangleFilter() = default;
  TriangleFilter(const ProjectedMesh& projected, TriangleId t)
      : triangle(t), corners(projected.mesh().triangles[t]), plane(projected.filter(projected.face_plane(t))) {
    const bool is_known = projected.image_error() < HUGE_VAL && projected.facing(t) != Sign::zero;
    facing = projected.facing(t) == Sign::positive ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const ImagePoint p = is_known ? projected.image(corners[k]) : ImagePoint{NAN, NAN};
      x[k] = p.x;
      y[k] = p.y;
    }
    const Point3& e = projected.eye().at;
    per_eye = quotient({-1, 0}, projected.is_perspective() ? plane(e) : plane.change(e));
  }

  bool has(VertexId v) const { return is_one_of(v, corners); }

  /// Whether the triangle certainly lies on one side of the line of the segment.
  bool is_beside(const SegmentFilter& s) const {
    const auto side = [&](std::size_t k) {
      const ErrorBounded turn = s.turn({x[k], y[k]});
      return turn.value > turn.error ? 1 : turn.value < -turn.error ? -1 : 0;
    };
    const int first = side(0);
    return first != 0 && side(1) == first && side(2) == first;
  }

  /// What the image tells for certain of the triangle and a segment.
  struct Overlap {
    bool is_none = false;    ///< both ends lie strictly beyond one of its sides
    unsigned is_within = 0;  ///< bit k: both ends are strictly on the inner side of the triangle's side k
    std::array<TwoDoubles, 3> value, error;

    /// O of the side from corner k to the next for an end, times facing, in the image.
    ErrorBounded at_p(std::size_t k) const { return {value[k][0], error[k][0]}; }
    ErrorBounded at_q(std::size_t k) const { return {value[k][1], error[k][1]}; }
  };
  Overlap overlap(const SegmentFilter& s) const {
    Overlap overlap;
    alignas(16) const std::array<double, 2> ends_x = {s.p.x, s.q.x}, ends_y = {s.p.y, s.q.y};
    const TwoDoubles sx = TwoDoubles::load(ends_x.data()), sy = TwoDoubles::load(ends_y.data());
    const double per_length = 2.2 * s.error, least = 9.1 * s.error * s.error + 0x1p-1000;
    const auto all = [](double of_both) { return TwoDoubles::all(of_both); };
    constexpr unsigned both = 3;
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned next = k == 2 ? 0 : k + 1;
      const double dx = facing * (x[next] - x[k]), dy = facing * (y[next] - y[k]), length = std::fabs(dx) + std::fabs(dy);
      const TwoDoubles px = sx - all(x[k]), py = sy - all(y[k]);
      const TwoDoubles value = overlap.value[k] = all(dx) * py - all(dy) * px;
      const TwoDoubles error = overlap.error[k] =
          all(least + per_length * length) +
          all(per_length + 4.2 * ErrorBounded::u * length) * (px.magnitude() + py.magnitude());
      if ((value < -error).bits() == both) {
        overlap.is_none = true;
        return overlap;
      }
      overlap.is_within |= unsigned{(value > error).bits() == both} << k;
    }
    return overlap;
  }
};

}  // namespace hsr::internal
