#include "hsr/drawing/cut_parameter.h"

#include <cmath>

#include "geometry/polynomials.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

std::array<Enclosure, 3> enclosed_meet(const Plane& s, const Plane& t, const Plane& u, const Point3& origin) {
  const EnclosureArithmetic a;
  const auto d = polynomials::meet_point(a, s, t, u);
  const Enclosure w = polynomials::meet_value(a, s, t, u);
  return {Enclosure::difference(s.o.x, origin.x) + d.x / w, Enclosure::difference(s.o.y, origin.y) + d.y / w,
          Enclosure::difference(s.o.z, origin.z) + d.z / w};
}

std::array<Enclosure, 3> enclosed_point(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut,
                                        const Point3& origin) {
  const auto [s, t] = planes_of(mesh, view, support);
  return enclosed_meet(s, t, plane_of(mesh, view, cut), origin);
}

Enclosure enclosed_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return {0.0};
  if (cut.kind == Cut::Kind::end) return {1.0};
  if (support.is_edge()) {
    const Plane plane = plane_of(mesh, view, cut);
    const EnclosureArithmetic arithmetic;
    const Enclosure a = polynomials::value(arithmetic, plane, mesh.points[support.a]);
    const Enclosure b = polynomials::value(arithmetic, plane, mesh.points[support.b]);
    return a / (a - b);
  }
  if (cut == support.meet.from) return {0.0};
  if (cut == support.meet.to) return {1.0};
  const Point3 origin = planes_of(mesh, view, support)[0].o;
  const auto point = [&](const Cut& c) { return enclosed_point(mesh, view, support, c, origin); };
  const auto a = point(support.meet.from), b = point(support.meet.to), p = point(cut);
  std::size_t widest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(b[k].middle - a[k].middle) > std::fabs(b[widest].middle - a[widest].middle)) widest = k;
  return (p[widest] - a[widest]) / (b[widest] - a[widest]);
}

double rounded_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut) {
  if (cut.kind == Cut::Kind::start) return 0;
  if (cut.kind == Cut::Kind::end) return 1;
  if (const auto t = rounded(enclosed_parameter(mesh, view, support, cut))) return *t;
  return exact_parameter(mesh, view, support, cut).to_double();
}

}  // namespace hsr::internal
