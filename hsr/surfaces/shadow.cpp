#include "hsr/surfaces/shadow.h"

#include <iterator>
#include <utility>

namespace hsr::internal {

void shadow_on(const ProjectedMesh& projected, TriangleId t, TriangleId s, bool are_coplanar,
               std::vector<MapHalfPlane>& half_planes) {
  half_planes.clear();
  for (std::size_t k = 0; k < 3; ++k) half_planes.push_back(side_of_triangle(projected, t, k));
  if (!are_coplanar) {
    const MapLine meet = MapLine::meet(t, s);
    const Sign nearer = projected.facing(t) * projected.facing(s);
    half_planes.push_back({meet, meet.u == t.value ? nearer : -nearer});
  }
  if (projected.reaches_before_near(t)) half_planes.push_back(beyond_near(projected, t));
}

void subtract(MapPredicates& map, std::vector<ConvexPiece>& pieces, const std::vector<MapHalfPlane>& half_planes) {
  std::vector<ConvexPiece> left;
  for (ConvexPiece& piece : pieces) {
    ConvexPiece rest = piece;
    std::vector<ConvexPiece> outside;
    for (const MapHalfPlane& h : half_planes) {
      if (auto part = cut(map, rest, h)) outside.push_back(std::move(*part));
      if (rest.points.empty()) break;
    }
    if (rest.points.empty())
      left.push_back(std::move(piece));
    else
      std::move(outside.begin(), outside.end(), std::back_inserter(left));
  }
  pieces = std::move(left);
}

}  // namespace hsr::internal
