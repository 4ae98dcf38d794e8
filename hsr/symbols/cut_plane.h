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
      return points.near_plane();
    case Cut::Kind::near_line:
      return points.near_line(points.face_plane(TriangleId(cut.u)));
    case Cut::Kind::line:
      return Plane::along_axis(points.point(u), points.point(v), cut.axis);
    case Cut::Kind::sight_of_vertex:
      return Plane::of_sight_along_axis(points.eye(), points.point(u), cut.axis);
    case Cut::Kind::near_line_end:
      return points.near_line(Plane::along_axis(points.point(u), points.point(v), cut.axis));
    case Cut::Kind::across:
      return Plane::across(points.point(u), cut.axis);
    case Cut::Kind::start:
    case Cut::Kind::end:
      break;
  }
  throw PreconditionError("cut_plane: the ends of an edge are cut by no plane");
}

}  // namespace hsr::internal
