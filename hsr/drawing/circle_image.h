#pragma once

#include <array>
#include <optional>
#include <span>

#include "hsr/drawing/ellipse_arc.h"
#include "hsr/drawing/projection.h"
#include "hsr/drawing/space_circle.h"

namespace hsr::internal {

/// A projection in doubles: from points relative to its anchor to millimetres of paper.
class PaperMap {
 public:
  explicit PaperMap(const Projection& projection);

  SpaceVector relative(const Point3& p) const;
  Point2 at(const SpaceVector& p) const;
  /// The longest image of a unit of space at p.
  double magnification(const SpaceVector& p) const;
  /// The image of a circle: an ellipse, from 0 to 2 pi. Nothing where it reaches behind the eye, or is seen as a line.
  std::optional<EllipseArc> image(const SpaceCircle& circle) const;

 private:
  Point3 anchor_;
  std::array<std::array<double, 4>, 3> rows_;
};

/// Whether an ellipse passes through a point, to the rounding of the paper.
bool passes_through(const EllipseArc& ellipse, const Point2& p);

/// The ellipse of the same shape and direction that passes through the first and the last of some points, and nearest to those between
/// them. Nothing where the two are one point.
std::optional<EllipseArc> through_ends(const EllipseArc& ellipse, std::span<const Point2> points);

}  // namespace hsr::internal
