#pragma once

#include <array>

#include "geometry/bounded_point.h"
#include "geometry/error_bounded.h"
#include "geometry/view_plane.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/map_point.h"

namespace hsr::internal {

/// Where a point of the map lies, within a bound that was proven; infinite where doubles do not tell. Each coordinate has a
/// bound of its own, unlike those of a BoundedPoint2: points are sorted and compared by one of them, and where a crossing is
/// steep in the other, that one's bound would spoil it.
struct MapPlace {
  double x = 0, y = 0, error_x = 0, error_y = 0;
};

/// What is decided in the image: signs of the symbols of map_point.h. Exact. One object per thread.
class MapPredicates {
 public:
  explicit MapPredicates(const ProjectedMesh& projected);

  const ProjectedMesh& projected() const { return projected_; }
  const Mesh& mesh() const { return projected_.mesh(); }
  Predicates& exact() { return exact_; }

  ViewPlane plane(const MapLine& line) const;

  /// On which side of the line the point lies: positive, to its left as seen.
  Sign side(const MapLine& line, const MapPoint& p);
  Sign side(const MapLine& line, VertexId v);
  /// How m turns against l: positive, to the left. Zero: parallel in the image, or one line.
  Sign turn(const MapLine& l, const MapLine& m);
  /// Of one line under two names: positive, both run the same way.
  Sign same_way(const MapLine& l, const MapLine& m);
  /// Whether p and q are one point of the image.
  bool equal(const MapPoint& p, const MapPoint& q);
  /// Which of two points of the line comes first: negative, p.
  Sign order(const MapLine& line, const MapPoint& p, const MapPoint& q);
  /// Whether the plane of s is nearer than that of t where p is seen: positive, s; zero, they meet there. @pre neither is seen
  /// edge-on, and they are not parallel in space as well as seen from p
  Sign nearer(TriangleId s, TriangleId t, const MapPoint& p);
  Sign nearer(FacetId s, FacetId t, const MapPoint& p) { return nearer(first_triangle(s), first_triangle(t), p); }
  bool coplanar(TriangleId s, TriangleId t);
  bool coplanar(FacetId s, FacetId t) { return coplanar(first_triangle(s), first_triangle(t)); }

  /// Where the point is seen, relative to the first vertex of the mesh: coordinates that turn as they are seen.
  MapPlace place(const MapPoint& p) const;
  /// The point of the triangle's plane that is seen there.
  BoundedPoint3 point(const MapPoint& p, TriangleId t) const;
  BoundedPoint3 point(const MapPoint& p, FacetId facet) const { return point(p, first_triangle(facet)); }
  std::array<Rational, 2> exact_place(const MapPoint& p) const;

 private:
  bool are_of_planar_face(TriangleId s, TriangleId t) const;
  /// A line through q across `line`.
  ViewPlane across(const MapLine& line, const MapPoint& q);
  Point3 origin() const { return projected_.point(projected_.mesh().edges.front().a); }

  const ProjectedMesh& projected_;
  Predicates exact_;
  Camera camera_;
  bool is_mirrored_;  // the rows are: then x is negated
};

}  // namespace hsr::internal
