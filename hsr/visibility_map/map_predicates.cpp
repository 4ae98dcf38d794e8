#include "hsr/visibility_map/map_predicates.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/scene/line_filter.h"

namespace hsr::internal {

MapPredicates::MapPredicates(const ProjectedMesh& projected)
    : projected_(projected), exact_(projected.predicates()), camera_(projected.camera()) {
  const Point3& e = camera_.eye.at;
  if (camera_.eye.is_direction) {
    is_mirrored_ = e[largest_axis(e)] < 0;
    return;
  }
  const RationalVector axis = minus(rational(camera_.target), rational(e));
  is_mirrored_ = dot(cross(rational(projected.rows()[0]), rational(projected.rows()[1])), axis).sign() == Sign::positive;
}

ViewPlane MapPredicates::plane(const MapLine& line) const {
  switch (line.kind) {
    case MapLine::Kind::edge:
      return ViewPlane::of(projected_.sight_plane(VertexId(line.u), VertexId(line.v)));
    case MapLine::Kind::meet:
      return ViewPlane::of_meet(projected_.face_plane(TriangleId(line.u)), projected_.face_plane(TriangleId(line.v)));
    case MapLine::Kind::fold:
      return ViewPlane::of(projected_.fold_plane(static_cast<std::uint8_t>(line.u), static_cast<std::uint8_t>(line.v)));
    case MapLine::Kind::near:
      break;
  }
  return ViewPlane::of(
      projected_.cutting_plane(static_cast<std::uint8_t>(line.v)).line_with(projected_.face_plane(TriangleId(line.u))));
}

Sign MapPredicates::side(const MapLine& line, VertexId v) {
  if (line.kind != MapLine::Kind::edge) return exact_.side(camera_, plane(line), projected_.point(v));
  if (line.u == v.value || line.v == v.value) return Sign::zero;
  return LineFilter(projected_, VertexId(line.u), VertexId(line.v)).side(v, exact_);
}

Sign MapPredicates::side(const MapLine& line, const MapPoint& p) {
  if (p.is_vertex) return side(line, p.vertex);
  if (p.l == line || p.m == line) return Sign::zero;
  return exact_.side(camera_, plane(line), plane(p.l), plane(p.m));
}

Sign MapPredicates::turn(const MapLine& l, const MapLine& m) {
  if (l == m) return Sign::zero;
  return exact_.turn(camera_, plane(l), plane(m));
}

Sign MapPredicates::same_way(const MapLine& l, const MapLine& m) {
  if (l == m) return Sign::positive;
  // A corner of what makes the line lies off it, but for the corners of edges: then the mesh has another vertex.
  const auto agree = [&](VertexId v) {
    const Sign s = side(l, v);
    return s == Sign::zero ? s : s * side(m, v);
  };
  for (const MapLine& line : {l, m}) {
    if (line.kind == MapLine::Kind::edge || line.kind == MapLine::Kind::fold) continue;
    for (const VertexId v : mesh().triangles[TriangleId(line.u)])
      if (const Sign s = agree(v); s != Sign::zero) return s;
  }
  // Edges, or faces seen edge-on: an axis that does not lie in their view plane leads off it, from any vertex that has an image.
  const ViewPlane a = plane(l), b = plane(m);
  std::vector<VertexId> on_line = {VertexId(l.u), VertexId(l.v)};
  if (l.kind == MapLine::Kind::fold)
    on_line = {mesh().edges.front().a};
  else if (l.kind != MapLine::Kind::edge)
    on_line.assign(mesh().triangles[TriangleId(l.u)].begin(), mesh().triangles[TriangleId(l.u)].end());
  for (const VertexId v : on_line)
    for (int axis = 0; axis < 3; ++axis) {
      const ViewPlane off = ViewPlane::of(Plane::of_sight_along_axis(projected_.eye(), projected_.point(v), axis));
      const Sign s = exact_.turn(camera_, a, off);
      if (s != Sign::zero) return s * exact_.turn(camera_, b, off);
    }
  throw InvariantError("MapPredicates: a line that nothing is beside");
}

bool MapPredicates::equal(const MapPoint& p, const MapPoint& q) {
  if (p == q) return true;
  if (p.is_vertex && q.is_vertex) return LineFilter(projected_, p.vertex, q.vertex).is_point(exact_);
  const MapPoint& crossing = p.is_vertex ? q : p;
  const MapPoint& other = p.is_vertex ? p : q;
  return side(crossing.l, other) == Sign::zero && side(crossing.m, other) == Sign::zero;
}

ViewPlane MapPredicates::across(const MapLine& line, const MapPoint& q) {
  const ViewPlane l = plane(line);
  if (!q.is_vertex) {
    for (const MapLine& m : {q.l, q.m})
      if (m != line && turn(line, m) != Sign::zero) return plane(m);
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      const ViewPlane m = ViewPlane::of(Plane::of_sight_along_axis(projected_.eye(), projected_.point(q.vertex), axis));
      if (exact_.turn(camera_, l, m) != Sign::zero) return m;
    }
  }
  throw InvariantError("MapPredicates: no line crosses this one at its point");
}

Sign MapPredicates::order(const MapLine& line, const MapPoint& p, const MapPoint& q) {
  if (p == q) return Sign::zero;
  if (!p.is_vertex && q.is_vertex) return -order(line, q, p);
  const ViewPlane l = plane(line), m = across(line, q);
  const Sign rises = -exact_.turn(camera_, l, m);
  if (p.is_vertex) return rises * exact_.side(camera_, m, projected_.point(p.vertex));
  return rises * exact_.side(camera_, m, plane(p.l), plane(p.m));
}

/// The triangles of a planar face that crosses itself: dozens may cover a place, and each sign would be a zero that only exact
/// arithmetic tells.
bool MapPredicates::are_of_planar_face(TriangleId s, TriangleId t) const {
  const FaceId face = mesh().face_of[s];
  return face == mesh().face_of[t] && mesh().faces[face] != FaceUse::not_coplanar;
}

Sign MapPredicates::nearer(TriangleId s, TriangleId t, const MapPoint& p) {
  if (are_of_planar_face(s, t)) return Sign::zero;
  const MapLine meet = MapLine::meet(s, t);
  const Sign side_of_meet = side(meet, p);
  const Sign first = projected_.facing(s) * projected_.facing(t) * side_of_meet;
  return meet.u == s.value ? first : -first;
}

bool MapPredicates::coplanar(TriangleId s, TriangleId t) {
  if (are_of_planar_face(s, t)) return true;
  const Plane plane = projected_.face_plane(s);
  const auto& corners = mesh().triangles[t];
  for (const VertexId v : corners)
    if (projected_.side(plane, v, exact_) != Sign::zero) return false;
  return true;
}

namespace {

MapPlace to_place(const std::array<ErrorBounded, 2>& at) { return {at[0].value, at[1].value, at[0].error, at[1].error}; }

}  // namespace

MapPlace MapPredicates::place(const MapPoint& p) const {
  const auto at = p.is_vertex ? image_of_point(camera_, projected_.point(p.vertex), origin(), projected_.rows())
                              : image_of_crossing(camera_, plane(p.l), plane(p.m), origin(), projected_.rows());
  MapPlace place = to_place(at);
  if (is_mirrored_) place.x = -place.x;
  // The rows and errors hold only where the filter is proven.
  if (!exact_.filter_is_proven() || exact_.arithmetic() != Arithmetic::staged) place.error_x = place.error_y = HUGE_VAL;
  return place;
}

BoundedPoint3 MapPredicates::point(const MapPoint& p, TriangleId t) const {
  const Plane x = projected_.face_plane(t);
  if (!p.is_vertex && exact_.filter_is_proven()) {
    const BoundedPoint3 at = bounded_point(bounded_point(camera_, plane(p.l), plane(p.m), x));
    if (at.error < norm_max(at.p) * 0x1p-20) return at;
  }
  const RationalVector at =
      p.is_vertex ? exact_point(camera_, projected_.point(p.vertex), x) : exact_point(camera_, plane(p.l), plane(p.m), x);
  const Point3 q = {at[0].to_double(), at[1].to_double(), at[2].to_double()};
  return {q, ErrorBounded::u * norm_max(q) + 0x1p-1000};
}

std::array<Rational, 2> MapPredicates::exact_place(const MapPoint& p) const {
  auto at = p.is_vertex ? exact_image_of_point(camera_, projected_.point(p.vertex), origin(), projected_.rows())
                        : exact_image_of_crossing(camera_, plane(p.l), plane(p.m), origin(), projected_.rows());
  if (is_mirrored_) at[0] = -at[0];
  return at;
}

}  // namespace hsr::internal
