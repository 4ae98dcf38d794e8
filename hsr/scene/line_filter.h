#pragma once

#include <cmath>
#include <optional>

#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/segment_filter.h"

namespace hsr::internal {

/// The line through the images of two vertices a and b, prepared for many points: the sign of O(a, b, p), positive to the left
/// of a -> b, by the bound of SegmentFilter.
class LineFilter {
 public:
  LineFilter(const ProjectedMesh& projected, VertexId a, VertexId b) : projected_(projected), a_(a), b_(b) {
    if (is_known()) image_ = {projected.image(a), projected.image(b), projected.image_error()};
  }

  /// Zero: doubles cannot tell.
  Sign certain_side(VertexId p) const {
    if (!is_known()) return Sign::zero;
    const ErrorBounded turn = image_.turn(projected_.image(p));
    return turn.value > turn.error ? Sign::positive : turn.value < -turn.error ? Sign::negative : Sign::zero;
  }

  /// The sign of O(a, b, p) where doubles tell it, a zero too: exact images on a line along an axis need only comparisons, and
  /// elevations are full of them.
  std::optional<Sign> side_by_doubles(VertexId p) const {
    const Sign certain = certain_side(p);
    if (certain != Sign::zero) return certain;
    if (projected_.image_error() != 0 || (image_.dx != 0 && image_.dy != 0)) return std::nullopt;
    const ImagePoint& c = projected_.image(p);
    return image_.dx == 0 ? -sign_of(image_.dy) * sign_of(c.x - image_.p.x) : sign_of(image_.dx) * sign_of(c.y - image_.p.y);
  }

  /// The sign of O(a, b, p). Exact.
  Sign side(VertexId p, Predicates& exact) const {
    const std::optional<Sign> s = side_by_doubles(p);
    if (!s) return exact.side_beyond_filter(projected_.sight_plane(a_, b_), projected_.point(p));
    ++exact.counts().filter;
    if (*s == Sign::zero) ++exact.counts().zero;
    return *s;
  }

  /// Whether a and b are seen as one point, so that there is no line. Exact.
  bool is_point(Predicates& exact) const {
    if (is_known() && std::fabs(image_.dx) + std::fabs(image_.dy) > 9 * projected_.image_error() + 0x1p-900) return false;
    // Iff every plane of the line of sight of a contains b.
    for (int axis = 0; axis < 3; ++axis)
      if (exact.side(Plane::of_sight_along_axis(projected_.eye(), projected_.point(a_), axis), projected_.point(b_)) !=
          Sign::zero)
        return false;
    return true;
  }

  /// For a point p whose image is on the line: whether, on the way from a to b, it certainly comes earlier or later than a, and
  /// earlier or later than b.
  bool certainly_before_start(VertexId p) const { return along(p, image_.p) == Sign::negative; }
  bool certainly_after_start(VertexId p) const { return along(p, image_.p) == Sign::positive; }
  bool certainly_before_end(VertexId p) const { return along(p, image_.q) == Sign::negative; }
  bool certainly_after_end(VertexId p) const { return along(p, image_.q) == Sign::positive; }

 private:
  /// The sign of (p - o) . (b - a) in the image, or zero where doubles cannot tell.
  Sign along(VertexId p, const ImagePoint& o) const {
    if (!is_known()) return Sign::zero;
    const ErrorBounded along = image_.along(projected_.image(p), o);
    return along.value > along.error ? Sign::positive : along.value < -along.error ? Sign::negative : Sign::zero;
  }
  bool is_known() const { return projected_.image_error() < HUGE_VAL; }

  const ProjectedMesh& projected_;
  VertexId a_, b_;
  SegmentFilter image_;
};

}  // namespace hsr::internal
