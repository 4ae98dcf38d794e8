#pragma once

#include <array>

#include "geometry/enclosure.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::internal {

/// An enclosure of the parameter t of a cut; exact at the ends.
Enclosure enclosed_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut);

/// An enclosure of where three planes meet, relative to `origin`. @pre s is a span
std::array<Enclosure, 3> enclosed_meet(const Plane& s, const Plane& t, const Plane& u, const Point3& origin);

/// An enclosure of where a cut of an intersection is, relative to `origin`. @pre the carrier is one
std::array<Enclosure, 3> enclosed_point(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut,
                                        const Point3& origin);

/// The parameter t of a cut, correctly rounded. Rationals only where an enclosure leaves two doubles open.
double rounded_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut);

}  // namespace hsr::internal
