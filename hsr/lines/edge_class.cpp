#include "hsr/lines/edge_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/plane_filter.h"
#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"
#include "geometry/vector3.h"
#include "hsr/scene/half_space.h"

namespace hsr::internal {

namespace {

/// A triangle at the edge: the half-plane that starts at the edge and contains the apex.
struct HalfPlane {
  TriangleId triangle;
  VertexId apex;
  Sign side;            // of the edge's view plane; zero: seen edge-on
  bool passes = false;  // of a face with the edge inside
};

/// Brought near length 1, so that no product underflows.
Point3 scaled(const Point3& a) { return over(a, norm_max(a)); }

/// The normal of the plane of a, b and c, good to nine digits; where doubles have cancelled, by rationals.
Point3 normal(const Point3& a, const Point3& b, const Point3& c) {
  const Plane plane = Plane::of_face(a, b, c);
  const PlaneFilter filter(plane, Arithmetic::staged);
  const Point3 n = {filter.nx, filter.ny, filter.nz};
  if (norm_max(n) > filter.slope * 0x1p30 && norm_max(n) > filter.least && norm_max(n) < 0x1p900) return scaled(n);
  const auto exact = polynomials::normal(RationalArithmetic{}, plane);
  Rational most;
  for (const Rational& x : {exact.x, exact.y, exact.z}) most = std::max(most, x.sign() == Sign::negative ? -x : x);
  return {(exact.x / most).to_double(), (exact.y / most).to_double(), (exact.z / most).to_double()};
}

/// By how many degrees two half-planes at the edge deviate from one plane. @pre both apexes are off the line of the edge
double deviation(const ProjectedMesh& projected, const Edge& e, VertexId apex0, VertexId apex1) {
  const Point3 &a = projected.point(e.a), &b = projected.point(e.b);
  const Point3 n0 = normal(a, b, projected.point(apex0)), n1 = normal(a, b, projected.point(apex1));
  const Point3 n = cross(n0, n1);
  return std::atan2(std::sqrt(dot(n, n)), -dot(n0, n1)) * 180 / std::numbers::pi;
}

/// Two half-planes at one edge, told apart exactly.
class HalfPlanes {
 public:
  HalfPlanes(const ProjectedMesh& projected, Predicates& exact, const Edge& edge)
      : projected_(projected), exact_(exact), edge_(edge) {}

  HalfPlane of(TriangleId t) const { return {t, projected_.mesh().apex(t, edge_), projected_.side_of_edge(t, edge_)}; }

  /// The halves of a triangle that the edge runs through, or the one that begins along its side.
  void add(const EdgeContact& contact, std::vector<HalfPlane>& out) const {
    const auto& c = projected_.mesh().triangles[contact.triangle];
    const bool edge_on = projected_.facing(contact.triangle) == Sign::zero;
    const Point3 &a = projected_.point(edge_.a), &b = projected_.point(edge_.b);
    const Plane line = edge_on ? Plane::along_axis(a, b, dropped_axis(projected_, contact.triangle, exact_))
                               : projected_.sight_plane(edge_.a, edge_.b);
    bool has[2] = {false, false};
    for (std::size_t k = 0; k < 3; ++k) {
      if (contact.along < 3 && k != (contact.along + 2) % 3) continue;
      const Sign s = exact_.side(line, projected_.point(c[k]));
      if (s == Sign::zero || has[s == Sign::positive ? 0 : 1]) continue;
      has[s == Sign::positive ? 0 : 1] = true;
      out.push_back({contact.triangle, c[k], edge_on ? Sign::zero : s, true});
    }
  }

  Sign side(const HalfPlane& plane, const HalfPlane& other) const {
    return exact_.side(projected_.face_plane(plane.triangle), projected_.point(other.apex));
  }

  bool coincide(const HalfPlane& x, const HalfPlane& y) const {
    if (x.side != y.side || side(x, y) != Sign::zero) return false;
    // In one plane with the edge: on the same side of it where the plane is seen as two coordinates.
    for (int axis = 0; axis < 3; ++axis) {
      const Plane line = Plane::along_axis(projected_.point(edge_.a), projected_.point(edge_.b), axis);
      const Sign s = exact_.side(line, projected_.point(x.apex));
      if (s != Sign::zero) return s == exact_.side(line, projected_.point(y.apex));
    }
    return true;
  }

  /// Both on one side of the view plane: the eye lies on the side `facing` of a triangle's plane, and what is farther on the
  /// other.
  bool is_nearer(const HalfPlane& x, const HalfPlane& y) const {
    return side(x, y) * projected_.facing(x.triangle) == Sign::negative;
  }

 private:
  const ProjectedMesh& projected_;
  Predicates& exact_;
  const Edge& edge_;
};

/// Whether there are half-planes on both sides of the plane of this one.
bool is_pierced(const HalfPlane& plane, std::span<const HalfPlane> all, const HalfPlanes& half_planes) {
  bool positive = false, negative = false;
  for (const HalfPlane& h : all) {
    const Sign s = half_planes.side(plane, h);
    positive = positive || s == Sign::positive;
    negative = negative || s == Sign::negative;
  }
  return positive && negative;
}

std::optional<EdgeClass> class_by_faces(const ProjectedMesh& projected, Predicates& exact, EdgeId id, double crease,
                                        std::span<const EdgeContact> contacts) {
  const Edge& edge = projected.mesh().edges[id];
  const bool only_diagonal = edge.diagonal && !edge.of_face;
  const HalfPlanes half_planes(projected, exact, edge);
  std::vector<HalfPlane> all;
  for (const TriangleId t : projected.mesh().triangles_at(id)) all.push_back(half_planes.of(t));
  for (const EdgeContact& c : contacts) half_planes.add(c, all);

  std::optional<HalfPlane> nearest[2];
  bool differ = false;
  for (const HalfPlane& h : all) {
    differ = differ || !half_planes.coincide(all.front(), h);
    if (h.side == Sign::zero) continue;
    auto& best = nearest[h.side == Sign::positive ? 0 : 1];
    if (!best || half_planes.is_nearer(h, *best))
      best = h;
    else if (h.passes && half_planes.coincide(h, *best))
      best->passes = true;
  }
  const bool one_side = nearest[0].has_value() != nearest[1].has_value();
  if (only_diagonal) return one_side ? std::optional(EdgeClass::outline) : std::nullopt;
  if (all.empty()) return std::nullopt;
  if (!differ) return EdgeClass::boundary;
  if (one_side) return EdgeClass::outline;
  if (!nearest[0] || half_planes.side(*nearest[0], *nearest[1]) == Sign::zero) return EdgeClass::smooth;
  for (const auto& n : nearest)
    if (n->passes && is_pierced(*n, all, half_planes)) return EdgeClass::intersection;
  return deviation(projected, edge, nearest[0]->apex, nearest[1]->apex) > crease ? EdgeClass::sharp : EdgeClass::smooth;
}

/// An edge of two faces on opposite sides whose angle is far enough from the crease: sharp or smooth without any exact sign.
/// Nothing: to be looked at closely. Each normal is good to nine digits, and the cosine is trusted to six.
std::optional<EdgeClass> class_at_a_glance(const ProjectedMesh& projected, EdgeId id, double cosine) {
  const Edge& edge = projected.mesh().edges[id];
  const auto triangles = projected.mesh().triangles_at(id);
  if (triangles.size() != 2 || !edge.of_face || edge.wire) return std::nullopt;
  Point3 n[2];
  Sign side[2];
  const Point3& a = projected.point(edge.a);
  const Point3 along = minus(projected.point(edge.b), a);
  for (std::size_t k = 0; k < 2; ++k) {
    const TriangleId t = triangles[k];
    side[k] = projected.side_of_edge(t, edge);
    const Point3 out = minus(projected.point(projected.mesh().apex(t, edge)), a);
    n[k] = cross(along, out);
    // The normal errs by some roundings of these products.
    if (!(norm_max(n[k]) > norm_max(along) * norm_max(out) * 0x1p-20)) return std::nullopt;
  }
  if (side[0] * side[1] != Sign::negative) return std::nullopt;
  const double square = dot(n[0], n[0]) * dot(n[1], n[1]);
  if (!(square > 0x1p-900 && square < 0x1p900)) return std::nullopt;
  const double flatness = -dot(n[0], n[1]) / std::sqrt(square);  // the cosine of the deviation from flat
  if (flatness > cosine + 1e-6) return EdgeClass::smooth;
  if (flatness < cosine - 1e-6) return EdgeClass::sharp;
  return std::nullopt;
}

}  // namespace

std::optional<EdgeClass> edge_class(const ProjectedMesh& projected, Predicates& exact, EdgeId edge, const Crease& crease,
                                    std::span<const EdgeContact> contacts) {
  if (exact.arithmetic() == Arithmetic::staged && contacts.empty())
    if (const auto seen = class_at_a_glance(projected, edge, crease.cosine)) return seen;
  const auto by_faces = class_by_faces(projected, exact, edge, crease.degrees, contacts);
  const bool plain = !by_faces || by_faces == EdgeClass::smooth;
  return projected.mesh().edges[edge].wire && plain ? EdgeClass::wire : by_faces;
}

}  // namespace hsr::internal
