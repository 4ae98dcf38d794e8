#include "hsr/drawing/cut_parameter.h"

#include "geometry/polynomials.h"

namespace hsr {

Enclosure enclosed_parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return {0.0};
  if (cut.kind == Cut::Kind::end) return {1.0};
  const Plane plane = plane_of(mesh, view, cut);
  const EnclosureArithmetic arithmetic;
  const Enclosure a = polynomials::value(arithmetic, plane, mesh.points[edge.a]);
  const Enclosure b = polynomials::value(arithmetic, plane, mesh.points[edge.b]);
  return a / (a - b);
}

double rounded_parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return 0;
  if (cut.kind == Cut::Kind::end) return 1;
  if (const auto t = rounded(enclosed_parameter(mesh, view, edge, cut))) return *t;
  return parameter(mesh, view, edge, cut).to_double();
}

}  // namespace hsr
