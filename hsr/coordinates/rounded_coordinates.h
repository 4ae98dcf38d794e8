#pragma once

#include "hsr/coordinates/coordinates.h"
#include "hsr/drawing/projection.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/painters_order.h"
#include "hsr/symbols/map_point.h"

namespace hsr::internal {

/// Where the symbols that results are made of are, correctly rounded: enclosures answer, and rationals only where these leave
/// two doubles open. May be used by many threads at once.
class RoundedCoordinates {
 public:
  /// @pre mesh and view outlive it; the origin of the view's frame is in front of the eye
  RoundedCoordinates(const Mesh& mesh, const View& view) : mesh_(mesh), view_(view), frame_(mesh, view, view.frame.origin) {}

  PlacedPoint at(VertexId v) const;
  PlacedPoint at(const SupportingLine& support, const Cut& cut) const;
  /// The point of the facet's plane that is seen at a point of the map.
  PlacedPoint at(FacetId facet, const MapPoint& p) const;
  PlacedPoint at(FacetId facet, const PieceCorner& corner) const;

 private:
  using Enclosed = std::array<Enclosure, 3>;
  /// @param space relative to `origin`
  template <class Exact>
  PlacedPoint rounded(const Point3& origin, const Enclosed& space, const HomogeneousPoint& image, const Exact& exact) const;
  /// Where three planes meet.
  template <class Exact>
  PlacedPoint meet(const Plane& s, const Plane& t, const Plane& u, const Exact& exact) const;
  Plane face_plane(TriangleId t) const;
  Plane face_plane(FacetId facet) const { return face_plane(first_triangle(facet)); }

  const Mesh& mesh_;
  const View& view_;
  Projection frame_;
};

}  // namespace hsr::internal
