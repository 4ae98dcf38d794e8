#include "hsr/surfaces/fragments_in_cells.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/rational_vector.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/map_clipper.h"
#include "hsr/surfaces/rings.h"

namespace hsr::internal {

namespace {

class CellFragments {
 public:
  CellFragments(const SceneView& scene, const FragmentOptions& options) : scene_(scene), options_(options) {
    FragmentOptions of_cell = options;
    of_cell.lines = nullptr;
    for (const ViewParts::Cell& cell : scene.parts().cells()) {
      found_.push_back(visible_fragments(cell.scene, of_cell));
      auto& first = first_.emplace_back(scene.mesh().triangles.size() + 1, 0);
      for (const Fragment& f : found_.back().fragments) ++first[f.facet.value + 1U];
      for (std::size_t t = 1; t < first.size(); ++t) first[t] += first[t - 1];
    }
  }

  VisibleFragments united() {
    const ProjectedMesh& projected = scene_.parts().projected(options_.stop);
    struct Worker {
      MapPredicates at;
      RingLinker linker;
      std::vector<PlacedSide> sides;
      explicit Worker(const ProjectedMesh& projected) : at(projected), linker(at) {}
      MapPredicates& map() { return at; }
    };
    FragmentOptions options = options_;
    options.progress = {};
    VisibleFragments all = fragments_in_blocks(
        scene_.mesh(), options, [&] { return Worker(projected); },
        [&](Worker& worker, FacetId facet, FragmentParts& parts) {
          worker.sides.clear();
          for (std::size_t cell = 0; cell < found_.size(); ++cell)
            for (const MapSide& side : sides_in_cell(worker.at, facet, cell))
              worker.sides.push_back({side, worker.at.place(side.from), worker.at.place(side.to)});
          if (!worker.sides.empty()) parts.add(facet, worker.linker.link(worker.sides));
        });
    for (const VisibleFragments& one : found_) all.decisions += one.decisions;
    return all;
  }

 private:
  std::vector<MapSide> sides_in_cell(MapPredicates& map, FacetId facet, std::size_t k) const {
    const ViewParts::Cell& cell = scene_.parts().cells()[k];
    const VisibleFragments& found = found_[k];
    std::vector<MapSide> sides;
    for (std::size_t f = first_[k][facet.value]; f < first_[k][facet.value + 1U]; ++f)
      append_sides(found, found.fragments[f], sides);
    if (sides.empty()) return sides;
    for (MapSide& side : sides)
      side = {side.line.by_plane(cell.cell.plane), side.reversed, side.from.by_plane(cell.cell.plane),
              side.to.by_plane(cell.cell.plane)};
    MapClipper clipper(map);
    for (const CellSide& side : cell.cell.sides) clipper.keep(MapLine::fold(side.u, side.v), side.kept, sides);
    if (scene_.view().far) keep_before_far(map, clipper, first_triangle(facet), sides);
    return sides;
  }
  /// Of a facet that is seen from its positive side what is beyond a plane is seen on the positive side of the line in it. In one that is
  /// parallel to the far plane there is no line, and all of it is on one side.
  void keep_before_far(MapPredicates& map, MapClipper& clipper, TriangleId t, std::vector<MapSide>& sides) const {
    const auto& corners = scene_.mesh().triangles[t];
    const auto point = [&](std::size_t k) { return rational(scene_.mesh().points[corners[k]]); };
    const RationalVector normal = rational(scene_.view().far->normal);
    const auto rises = [&](std::size_t k) { return dot(normal, minus(point(k), point(0))).sign() != Sign::zero; };
    if (rises(1) || rises(2))
      clipper.keep(MapLine::near(t, View::far_number), -map.projected().facing(t), sides);
    else if (dot(normal, minus(point(0), rational(scene_.view().far->point))).sign() == Sign::positive)
      sides.clear();
  }

  const SceneView& scene_;
  const FragmentOptions& options_;
  std::vector<VisibleFragments> found_;          // by cell
  std::vector<std::vector<std::size_t>> first_;  // by cell, then triangle: the first of its fragments
};

}  // namespace

VisibleFragments fragments_in_cells(const SceneView& scene, const FragmentOptions& options) {
  if (scene.mesh().triangles.empty()) return {};
  return CellFragments(scene, options).united();
}

}  // namespace hsr::internal
