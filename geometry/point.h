#pragma once

namespace hsr {

/// A point, or a vector, as given: three finite doubles, exact by definition.
struct Point3 {
  double x = 0, y = 0, z = 0;

  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
};

/// A point of a plane: of an image, or of the paper.
struct Point2 {
  double x = 0, y = 0;

  friend constexpr bool operator==(const Point2&, const Point2&) = default;
};

/// The homogeneous viewpoint: w = 1, an eye at (x, y, z); w = 0, an eye at infinity in the direction (x, y, z), which points
/// from the scene toward the viewer.
struct Viewpoint {
  Point3 at;
  bool is_direction = true;

  constexpr double w() const { return is_direction ? 0.0 : 1.0; }
  friend constexpr bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

}  // namespace hsr
