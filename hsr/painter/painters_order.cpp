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

std::array<std::array<Rational, 3>, 2> exact_ends(const Mesh& mesh, const OrderedWire& wire) {
  const RationalVector a = rational(mesh.points[mesh.edges[wire.edge].a]), b = rational(mesh.points[mesh.edges[wire.edge].b]);
  const auto at = [&](const Rational& t) {
    RationalVector p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + t * (b[k] - a[k]);
    return p;
  };
  return {at(wire.from), at(wire.to)};
}

}  // namespace hsr
