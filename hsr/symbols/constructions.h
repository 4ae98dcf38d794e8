#pragma once

#include <array>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "hsr/symbols/cut.h"
#include "hsr/symbols/map_point.h"
#include "hsr/view/view.h"

namespace hsr {

/// The plane that makes a cut. Exact: yes. @pre neither start nor end
Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut);

/// A point of the visibility map in space, exactly: the point of the facet's plane that is seen there.
std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, FacetId facet, const MapPoint& p);

}  // namespace hsr
