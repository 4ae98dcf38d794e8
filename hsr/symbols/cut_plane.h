#pragma once

#include "geometry/error.h"
#include "geometry/mesh.h"
#include "geometry/plane.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// The plane that makes a cut, over the points of a ProjectedMesh or over points as given. @pre neither start nor end
template <class Points>
Plane cut_plane(const Points& points, const Cut& cut) {
  const VertexId u(cut.u), v(cut.v);
  switch (cut.kind) {
    case Cut::Kind::sight:
      return points.sight_plane(u, v);
    case Cut::Kind::face:
      return points.face_plane(TriangleId(cut.u));
    case Cut::Kind::near:
      return points.cutting_plane(cut.plane());
    case Cut::Kind::near_line:
      return points.cutting_plane(cut.plane()).line_with(points.face_plane(TriangleId(cut.u)));
    case Cut::Kind::line:
      return Plane::along_axis(points.point(u), points.point(v), cut.axis);
    case Cut::Kind::sight_of_vertex:
      return Plane::of_sight_along_axis(points.eye(), points.point(u), cut.axis);
    case Cut::Kind::near_line_end:
      return points.cutting_plane(cut.plane()).line_with(Plane::along_axis(points.point(u), points.point(v), cut.dropped()));
    case Cut::Kind::fold:
      return points.fold_plane(static_cast<std::uint8_t>(cut.u), static_cast<std::uint8_t>(cut.v));
    case Cut::Kind::across:
      return Plane::across(points.point(u), cut.axis);
    case Cut::Kind::start:
    case Cut::Kind::end:
      break;
  }
  throw PreconditionError("cut_plane: the ends of an edge are cut by no plane");
}

}  // namespace hsr::internal
