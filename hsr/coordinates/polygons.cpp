#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "hsr/coordinates/coordinates.h"
#include "hsr/coordinates/rounded_coordinates.h"

namespace hsr {

using namespace internal;

namespace {

/// The polygons that make(k) gives, in parallel.
template <class Make>
std::vector<PlacedPolygon> each(std::size_t n, const Make& make) {
  std::vector<PlacedPolygon> all(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 64), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) all[k] = make(k);
  });
  return all;
}

}  // namespace

std::vector<PlacedPolygon> polygons(const SceneView& scene, const VisibleFragments& fragments) {
  const RoundedCoordinates coordinates(scene.mesh(), scene.view());
  return each(fragments.fragments.size(), [&](std::size_t k) {
    const Fragment& fragment = fragments.fragments[k];
    PlacedPolygon polygon{scene.mesh().face_of[first_triangle(fragment.facet)], fragment.facet, {}};
    for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) {
      auto& ring = polygon.rings.emplace_back();
      for (const MapCorner& corner : fragments.rings[r]) ring.push_back(coordinates.at(fragment.facet, corner.at));
    }
    return polygon;
  });
}

std::vector<PlacedPolygon> polygons(const SceneView& scene, const PaintersOrder& order) {
  const RoundedCoordinates coordinates(scene.mesh(), scene.view());
  return each(order.pieces.size(), [&](std::size_t k) {
    const OrderedPiece& piece = order.pieces[k];
    PlacedPolygon polygon{scene.mesh().face_of[first_triangle(piece.facet)], piece.facet, {{}}};
    for (const PieceCorner& corner : order.corners_of(piece)) polygon.rings[0].push_back(coordinates.at(piece.facet, corner));
    return polygon;
  });
}

}  // namespace hsr
