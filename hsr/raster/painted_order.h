#pragma once

#include "hsr/image.h"
#include "hsr/model.h"
#include "hsr/painter/painters_order.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr {

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
Image<Colour> paint(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples,
                    const std::vector<Colour>& colours, double opacity);
/// Of a scene that nothing else looks at.
inline Image<Colour> paint(const Mesh& mesh, const View& view, const PaintersOrder& order, const SampleGrid& samples,
                           const std::vector<Colour>& colours, double opacity) {
  return paint(SceneView(mesh, view), order, samples, colours, opacity);
}

}  // namespace hsr
