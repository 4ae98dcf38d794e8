#include "bench/peers/envelope.h"

#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_3.h>

#include <algorithm>
#include <list>
#include <sstream>

#include "bench/seconds.h"
#include "geometry/error.h"
#include "geometry/rational_vector.h"

namespace hsr::bench {

using namespace internal;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Triangles = CGAL::Env_triangle_traits_3<Kernel>;
using Traits = CGAL::Env_surface_data_traits_3<Triangles, std::uint32_t>;
using Diagram = CGAL::Envelope_diagram_2<Traits>;

// Through text: which type CGAL takes for exact numbers depends on how it was built.
Number number(const Rational& x) {
  Kernel::Exact_kernel::FT exact;
  std::istringstream(x.to_string()) >> exact;
  return Number(exact);
}
Rational rational_of(const Number& x) {
  std::ostringstream text;
  text << CGAL::exact(x);
  return Rational::from_string(text.str());
}

/// Twice the area to the left of a closed walk.
template <class Circulator>
Number twice_area(Circulator begin) {
  Number sum = 0;
  Circulator c = begin;
  do {
    const auto &p = c->source()->point(), &q = c->target()->point();
    sum += p.x() * q.y() - p.y() * q.x();
  } while (++c != begin);
  return sum;
}

}  // namespace

Envelope envelope(const Mesh& mesh, const View& view, bool with_areas) {
  require(!view.is_perspective(), "envelope: a parallel view expected");
  Envelope result;
  std::list<Traits::Xy_monotone_surface_3> surfaces;
  const RationalVector d = rational(view.viewpoint.at), n = cross(rational(view.frame.right), rational(view.frame.up));
  result.prepare = elapsed([&] {
                     IndexedVector<VertexId, Kernel::Point_3> at(mesh.points.size());
                     for (std::size_t v = 0; v < at.size(); ++v) {
                       const RationalVector p = rational(mesh.points[VertexId(v)]);
                       const auto xy = image(view, p);
                       // Its viewer is at z = -infinity.
                       at[VertexId(v)] = Kernel::Point_3(number(xy[0]), number(xy[1]), number(-(dot(n, p) / dot(n, d))));
                     }
                     for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
                       const auto& c = mesh.triangles[TriangleId(t)];
                       const auto flat = [&](VertexId v) { return Kernel::Point_2(at[v].x(), at[v].y()); };
                       if (CGAL::collinear(flat(c[0]), flat(c[1]), flat(c[2]))) continue;
                       surfaces.emplace_back(Triangles::Surface_3(at[c[0]], at[c[1]], at[c[2]]), static_cast<std::uint32_t>(t));
                     }
                   }).clock;
  Diagram diagram;
  result.compute = elapsed([&] { CGAL::lower_envelope_3(surfaces.begin(), surfaces.end(), diagram); }).clock;
  if (with_areas) result.areas.resize(mesh.triangles.size());
  for (auto f = diagram.faces_begin(); f != diagram.faces_end(); ++f) {
    if (f->number_of_surfaces() == 0) continue;
    ++result.regions;
    if (!with_areas) continue;
    std::uint32_t lowest = 0xffffffffU;
    for (auto s = f->surfaces_begin(); s != f->surfaces_end(); ++s) lowest = std::min(lowest, s->data());
    Number twice = twice_area(f->outer_ccb());
    for (auto hole = f->holes_begin(); hole != f->holes_end(); ++hole) twice += twice_area(*hole);
    Rational& area = result.areas[lowest];
    area = area + rational_of(twice) / Rational(2.0);
  }
  return result;
}

}  // namespace hsr::bench
