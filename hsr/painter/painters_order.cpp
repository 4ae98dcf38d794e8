#include "hsr/painter/painters_order.h"

#include "geometry/constructed_point.h"
#include "geometry/rational_vector.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

using namespace internal;

std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, FacetId facet, const PieceCorner& corner) {
  if (corner.vertex.is_valid()) return rational(mesh.points[corner.vertex]);
  const auto& c = mesh.triangles[first_triangle(facet)];
  return ConstructedPoint::meet(Plane::of_face(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]),
                                plane_of(mesh, view, corner.a), plane_of(mesh, view, corner.b))
      .exact();
}

}  // namespace hsr
