#pragma once

#include "geometry/near_value.h"
#include "hsr/surfaces/region_clipper.h"
#include "hsr/view/section_cells.h"

namespace hsr::internal {

inline CuttingPlane cutting_plane(const SectionPlane& plane) {
  const RationalVector normal = rational(plane.normal);
  return {normal, -dot(normal, rational(plane.point))};
}

/// The side of a cell, positive where the cell is.
inline CuttingPlane cutting_plane_of(const View& view, const CellSide& side) {
  CuttingPlane all = cutting_plane(view.planes[side.u - 1U]);
  if (side.u != side.v) {
    const CuttingPlane second = cutting_plane(view.planes[side.v - 1U]);
    const RationalVector eye = rational(view.viewpoint.at);
    const auto at_eye = [&](const CuttingPlane& x) { return view.is_perspective() ? x.at(eye) : dot(x.gradient, eye); };
    const Rational first_at_eye = at_eye(all), second_at_eye = at_eye(second);
    const auto combined = [&](const Rational& a, const Rational& b) -> Rational {
      return a * second_at_eye - first_at_eye * b;
    };
    for (std::size_t k = 0; k < 3; ++k) all.gradient[k] = combined(all.gradient[k], second.gradient[k]);
    all.offset = combined(all.offset, second.offset);
  }
  if (side.kept == Sign::negative) {
    for (Rational& x : all.gradient) x = -x;
    all.offset = -all.offset;
  }
  return all;
}

/// Positive before the far plane. @pre the view has one
inline CuttingPlane before_far(const View& view) {
  CuttingPlane far = cutting_plane(*view.far);
  for (Rational& x : far.gradient) x = -x;
  far.offset = -far.offset;
  return far;
}

}  // namespace hsr::internal
