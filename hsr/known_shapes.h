#pragma once

#include <cstdint>

#include "geometry/point.h"

namespace hsr {

/// What a surface is whose triangles a mesh has.
enum class SurfaceKind : std::uint8_t { plane, cylinder, cone, sphere, torus, revolution, other };

/// A surface of a B-rep.
struct KnownSurface {
  SurfaceKind kind = SurfaceKind::other;
  Point3 point;       ///< on the axis; of a sphere its centre; of a plane any point of it; other: nothing
  Point3 direction;   ///< of the axis, or the normal of a plane; length 1
  double radius = 0;  ///< of a cylinder or a sphere
};

/// A circle that an edge of a B-rep lies on.
struct KnownCircle {
  Point3 centre;
  Point3 axis;  ///< length 1
  double radius = 0;
};

}  // namespace hsr
