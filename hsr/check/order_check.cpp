#include "hsr/check/sample_checks.h"
#include "hsr/raster/capped_samples.h"
#include "hsr/raster/caster.h"
#include "hsr/scene/facet.h"

namespace hsr {

using namespace internal;

OrderCheck check_order(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples) {
  const Mesh& mesh = scene.mesh();
  OrderCheck check;
  const Image<std::uint32_t> painted = paint(scene, order, samples);
  const CastImage seen = cast(scene, samples);
  const Image<std::uint8_t> capped = capped_samples(scene, samples);
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      // Caps are painted after the pieces.
      const std::uint32_t piece = !capped.pixels.empty() && capped.at(i, j) != 0 ? no_piece : painted.at(i, j);
      const TriangleId cast = seen.triangles.at(i, j);
      ++check.samples;
      if (cast.is_valid()) ++check.covered;
      const FacetId shown = piece == no_piece ? FacetId() : order.pieces[piece].facet;
      if (shown == (cast.is_valid() ? facet_of(mesh, cast) : FacetId())) continue;
      if (check.wrong++ == 0) check.first_wrong = {i, j};
    }
  return check;
}

}  // namespace hsr
