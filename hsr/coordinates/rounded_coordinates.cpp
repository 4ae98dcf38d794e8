#include "hsr/coordinates/rounded_coordinates.h"

#include <cmath>
#include <optional>

#include "geometry/rational_vector.h"
#include "hsr/drawing/cut_parameter.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

template <class Exact>
PlacedPoint RoundedCoordinates::rounded(const Point3& origin, const Enclosed& space, const HomogeneousPoint& image,
                                        const Exact& exact) const {
  std::optional<RationalVector> in_space;
  const auto exact_space = [&]() -> const RationalVector& {
    if (!in_space) in_space = exact();
    return *in_space;
  };
  const auto in_doubles = [](const Enclosure& x, const auto& exactly) {
    const std::optional<double> known = hsr::internal::rounded(x);
    return (known ? *known : exactly().to_double()) + 0.0;  // never -0
  };
  const auto space_at = [&](std::size_t axis) {
    return in_doubles(Enclosure(origin[static_cast<int>(axis)]) + space[axis], [&] { return exact_space()[axis]; });
  };
  const auto paper_at = [&](const Enclosure& x, std::size_t axis) {
    return in_doubles(x / image.w, [&] { return frame_.exact(exact_space())[axis]; });
  };
  return {{space_at(0), space_at(1), space_at(2)}, {paper_at(image.x, 0), paper_at(image.y, 1)}};
}

template <class Exact>
PlacedPoint RoundedCoordinates::meet(const Plane& s, const Plane& t, const Plane& u, const Exact& exact) const {
  return rounded(s.o, enclosed_meet(s, t, u, s.o), frame_.at(s, t, u), exact);
}

Plane RoundedCoordinates::face_plane(TriangleId t) const {
  const auto& c = mesh_.triangles[t];
  return Plane::of_face(mesh_.points[c[0]], mesh_.points[c[1]], mesh_.points[c[2]]);
}

PlacedPoint RoundedCoordinates::at(VertexId v) const {
  const Point3& p = mesh_.points[v];
  PlacedPoint placed = rounded(p, {}, frame_.at(v), [&] { return rational(p); });
  placed.space = p;
  return placed;
}

PlacedPoint RoundedCoordinates::at(const SupportingLine& support, const Cut& cut) const {
  if (cut.kind == Cut::Kind::start) return at(support.a);
  if (cut.kind == Cut::Kind::end) return at(support.b);
  const auto exact = [&] { return exact_point(mesh_, view_, support, cut); };
  if (!support.is_edge()) {
    const auto [s, t] = planes_of(mesh_, view_, support);
    return meet(s, t, plane_of(mesh_, view_, cut), exact);
  }
  const Point3 &a = mesh_.points[support.a], &b = mesh_.points[support.b];
  const Enclosure t = enclosed_parameter(mesh_, view_, support, cut);
  const auto along = [&](int axis) { return t * Enclosure::difference(b[axis], a[axis]); };
  return rounded(a, {along(0), along(1), along(2)}, frame_.at(support, cut), exact);
}

PlacedPoint RoundedCoordinates::at(FacetId facet, const MapPoint& p) const {
  const auto exact = [&] { return exact_point(mesh_, view_, facet, p); };
  if (!p.is_vertex) {
    const auto plane = [&](const MapLine& line) {
      if (line.kind == MapLine::Kind::edge)
        return Plane::of_sight(view_.viewpoint, mesh_.points[VertexId(line.u)], mesh_.points[VertexId(line.v)]);
      const auto v = static_cast<std::uint8_t>(line.v);
      if (line.kind == MapLine::Kind::fold) return view_.fold_plane(static_cast<std::uint8_t>(line.u), v);
      return view_.cutting_plane(v).line_with(face_plane(TriangleId(line.u)));
    };
    if (p.l.kind != MapLine::Kind::meet && p.m.kind != MapLine::Kind::meet)
      return meet(face_plane(facet), plane(p.l), plane(p.m), exact);
    constexpr Enclosure::Wide unknown = std::numeric_limits<Enclosure::Wide>::infinity();
    const Enclosure anything(0, unknown);
    return rounded({}, {anything, anything, anything}, {anything, anything, Enclosure(1.0)}, exact);
  }
  for (const VertexId own : mesh_.triangles[first_triangle(facet)])
    if (own == p.vertex) return at(own);
  // Its line of sight is where two planes that contain it meet: those along the axes in which it is least steep.
  const Point3 &q = mesh_.points[p.vertex], &e = view_.viewpoint.at;
  const auto run = [&](int axis) { return std::fabs(view_.is_perspective() ? e[axis] - q[axis] : e[axis]); };
  const int most = run(0) >= run(1) && run(0) >= run(2) ? 0 : run(1) >= run(2) ? 1 : 2;
  PlacedPoint placed = meet(face_plane(facet), Plane::of_sight_along_axis(view_.viewpoint, q, (most + 1) % 3),
                            Plane::of_sight_along_axis(view_.viewpoint, q, (most + 2) % 3), exact);
  placed.paper = at(p.vertex).paper;
  return placed;
}

PlacedPoint RoundedCoordinates::at(FacetId facet, const PieceCorner& corner) const {
  if (corner.vertex.is_valid()) return at(corner.vertex);
  return meet(face_plane(facet), plane_of(mesh_, view_, corner.a), plane_of(mesh_, view_, corner.b),
              [&] { return exact_point(mesh_, view_, facet, corner); });
}

}  // namespace hsr::internal
