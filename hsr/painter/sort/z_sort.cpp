#include "hsr/painter/sort/z_sort.h"

#include <algorithm>
#include <cmath>

#include "hsr/painter/order_in_cells.h"
#include "hsr/painter/sort/image_pieces.h"
#include "hsr/painter/sort/z_sort_observer.h"
#include "hsr/painter/wires.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

/// @param observer is told; null: nobody is
PaintersOrder sorted(const SceneView& scene, DepthKey key, ZSortObserver* observer) {
  PaintersOrder order;
  order.wires = whole_wires(scene);
  if (scene.mesh().triangles.empty()) return order;
  const ProjectedMesh& projected = scene.parts().projected();
  const FacePieces pieces = face_pieces(projected);
  if (observer != nullptr) observer->began(pieces);
  const Camera camera = projected.camera();
  const Point3& e = camera.eye.at;
  // Along the direction in which the eye looks.
  const Point3 away = camera.eye.is_direction ? Point3{-e.x, -e.y, -e.z}
                                              : Point3{camera.target.x - e.x, camera.target.y - e.y, camera.target.z - e.z};
  const auto depth = [&](const Point3& p) { return p.x * away.x + p.y * away.y + p.z * away.z; };
  const MapPredicates map(projected);
  struct Place {
    double depth;
    std::uint32_t piece;
  };
  std::vector<Place> places;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    double farthest = -HUGE_VAL, sum = 0;
    std::size_t corners = 0;
    const auto add = [&](const Point3& p) {
      const double d = depth(p);
      farthest = std::max(farthest, d);
      sum += d;
      ++corners;
    };
    for (const VertexId v : pieces.rings[i]) add(projected.point(v));
    if (corners == 0)
      for (const MapPoint& p : pieces.shape(projected, i).points)
        add(p.is_vertex ? projected.point(p.vertex) : map.point(p, pieces.facet[i]).p);
    places.push_back({key == DepthKey::centroid ? sum / static_cast<double>(corners) : farthest, i});
    if (observer != nullptr) observer->keyed(i, places.back().depth);
  }
  std::sort(places.begin(), places.end(), [&](const Place& x, const Place& y) {
    return x.depth != y.depth ? x.depth > y.depth : projected.ties().is_above(y.piece, x.piece);
  });
  if (observer != nullptr) {
    std::vector<std::uint32_t> told;
    for (const Place& p : places) told.push_back(p.piece);
    observer->sorted(told);
  }
  for (const Place& p : places) append(projected, pieces, p.piece, order);
  for (OrderedWire& wire : order.wires) {
    const Edge& edge = scene.mesh().edges[wire.edge];
    const double a = depth(projected.point(edge.a)), b = depth(projected.point(edge.b));
    const double own = key == DepthKey::centroid ? (a + b) / 2 : std::max(a, b);
    wire.before = static_cast<std::uint32_t>(
        std::partition_point(places.begin(), places.end(), [&](const Place& p) { return p.depth >= own; }) - places.begin());
  }
  std::stable_sort(order.wires.begin(), order.wires.end(),
                   [](const OrderedWire& x, const OrderedWire& y) { return x.before < y.before; });
  return order;
}

}  // namespace

PaintersOrder z_sort(const SceneView& scene, DepthKey key) {
  if (scene.view().has_cells())
    return order_in_cells(scene, [&](const ViewParts::Cell& cell) { return z_sort(cell.scene, key); });
  return sorted(scene, key, nullptr);
}

PaintersOrder z_sort(const SceneView& scene, DepthKey key, ZSortObserver& observer) { return sorted(scene, key, &observer); }

}  // namespace hsr::internal
