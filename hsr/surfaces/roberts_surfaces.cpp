#include "hsr/surfaces/roberts_surfaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "geometry/error.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/fragment_invariants.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/rings.h"
#include "hsr/surfaces/shadow.h"
#include "hsr/visibility_map/convex_piece.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

namespace {

class Subtraction {
 public:
  Subtraction(const ProjectedMesh& projected, const Occluders& occluders)
      : map_(projected), projected_(projected), occluders_(occluders) {}

  /// Appends the sides of the visible pieces of a facet.
  void visible_sides(FacetId facet, std::vector<MapSide>& sides);

  MapPredicates& map() { return map_; }

 private:
  MapPredicates map_;
  const ProjectedMesh& projected_;
  const Occluders& occluders_;
};

void Subtraction::visible_sides(FacetId facet, std::vector<MapSide>& sides) {
  const Mesh& mesh = projected_.mesh();
  if (projected_.facing(facet) == Sign::zero) return;
  const TriangleId end = facet_end(mesh, facet);
  std::vector<ConvexPiece> pieces;
  std::vector<MapHalfPlane> half_planes;
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U)) {
    if (!projected_.reaches_beyond_near(t)) continue;
    pieces.assign(1, convex_piece(projected_, t));
    if (projected_.reaches_before_near(t)) cut(map_, pieces[0], beyond_near(projected_, t));
    if (pieces[0].points.empty()) continue;
    occluders_.tree.visit(projected_.box(t), [&](std::uint32_t i) {
      const TriangleId other = occluders_.triangles[i];
      if (facet_of(mesh, other) == facet) return true;
      const bool are_coplanar = map_.coplanar(other, first_triangle(facet));
      if (are_coplanar && projected_.ties().is_above(facet, facet_of(mesh, other))) return true;
      shadow_on(projected_, other, first_triangle(facet), are_coplanar, half_planes);
      subtract(map_, pieces, half_planes);
      return !pieces.empty();
    });
    for (const ConvexPiece& piece : pieces)
      for (std::size_t k = 0; k < piece.points.size(); ++k)
        sides.push_back({piece.lines[k].line, piece.lines[k].inner == Sign::negative, piece.points[k],
                         piece.points[(k + 1) % piece.points.size()]});
  }
}

}  // namespace

VisibleFragments roberts_surfaces(const SceneView& scene, const FragmentOptions& options) {
  if (scene.view().has_section())
    throw InputError("section: surfaces by the method roberts know no caps, expected the method auto or appel");
  const Mesh& mesh = scene.mesh();
  const ProjectedMesh& projected = scene.parts().projected(options.stop);
  const Occluders& occluders = scene.parts().occluders(Excluded::edge_on, options.stop);
  VisibleFragments all = fragments_in_blocks(
      mesh, options, [&] { return Subtraction(projected, occluders); },
      [](Subtraction& subtraction, FacetId facet, FragmentParts& parts) {
        std::vector<MapSide> sides;
        subtraction.visible_sides(facet, sides);
        parts.add(facet, link_rings(subtraction.map(), sides));
      });
#ifdef HSR_CHECKS
  if (projected.arithmetic() != Arithmetic::double_only) check_invariants(projected, all);
#endif
  return all;
}

}  // namespace hsr::internal
