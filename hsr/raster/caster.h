#pragma once

#include "geometry/mesh.h"
#include "geometry/predicates.h"
#include "hsr/image.h"
#include "hsr/model.h"
#include "hsr/painter/painters_order.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr {

/// What is seen at each sample, and how it was decided.
struct CastImage {
  Image<TriangleId> triangles;  ///< not valid: nothing is there
  DecisionCounts decisions;     ///< of the signs that doubles did not decide at once

  /// The face seen at a sample; not valid: none.
  FaceId face(const Mesh& mesh, int i, int j) const {
    const TriangleId t = triangles.at(i, j);
    return t.is_valid() ? mesh.face_of[t] : FaceId();
  }
};

/// The triangle that each sample's line of sight meets nearest to the eye, beyond the near plane; none where a cap of a section is seen.
///
///   (1) triangles that share an edge, and lie on both sides of it as seen, leave no sample between them and share none
///   (2) samples on edges are decided as if moved (samples.h); so are equal depths of triangles that cross there
///   (3) of triangles in one plane the one on top is seen (TieRule); triangles seen edge-on are not
///   (4) the result does not depend on the number of threads, nor the counts
///
/// @throws PreconditionError if the samples are no doubles, or the viewpoint is in their plane
/// Exact: yes. Degenerate: docs/conventions.md, "Hidden". Cost: O(n log n) for the tree; then per tile of samples what overlaps
/// it and is not behind all that was found; parallel.
CastImage cast(const SceneView& scene, const SampleGrid& samples);
/// Of a scene that nothing else looks at.
inline CastImage cast(const Mesh& mesh, const View& view, const SampleGrid& samples) {
  return cast(SceneView(mesh, view), samples);
}

/// Paints the pieces one over the other, far to near: the piece that each sample shows in the end, or no_piece.
///
/// @throws PreconditionError as cast() does (caster.h), and if a corner is not in front of the eye as the samples are
/// Exact: yes, with the rule for samples on edges (samples.h). Cost: O(pieces + samples painted).
/// Source: Newell, Newell & Sancha 1972.
Image<std::uint32_t> paint(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples);
/// Of a scene that nothing else looks at.
inline Image<std::uint32_t> paint(const Mesh& mesh, const View& view, const PaintersOrder& order, const SampleGrid& samples) {
  return paint(SceneView(mesh, view), order, samples);
}
constexpr std::uint32_t no_piece = 0xffffffffU;

/// Paints the pieces in the colours of their faces on white, composited in floats; each opacity is multiplied by `opacity`.
/// @throws PreconditionError as the other does
Image<Colour> paint(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples,
                    const std::vector<Colour>& colours, double opacity);
/// Of a scene that nothing else looks at.
inline Image<Colour> paint(const Mesh& mesh, const View& view, const PaintersOrder& order, const SampleGrid& samples,
                           const std::vector<Colour>& colours, double opacity) {
  return paint(SceneView(mesh, view), order, samples, colours, opacity);
}

}  // namespace hsr
