#pragma once

#include <array>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "hsr/symbols/cut.h"
#include "hsr/symbols/map_point.h"
#include "hsr/view/view.h"

namespace hsr {

/// The plane that makes a cut. Exact: yes.
/// @throws PreconditionError for the start or the end of an edge, which no plane makes
Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut);

/// A point of the visibility map in space, exactly: the point of the facet's plane that is seen there.
/// @throws PreconditionError if the facet is seen edge-on, or two lines that cross there are parallel in the image
std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, FacetId facet, const MapPoint& p);
/// The point of another plane that is seen there.
/// @throws PreconditionError if the line of sight is parallel to the plane, or two lines that cross there are parallel in the image
std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, const Plane& plane, const MapPoint& p);

}  // namespace hsr
