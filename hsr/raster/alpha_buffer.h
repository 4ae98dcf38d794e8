#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/model.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A picture of transparent faces, and what it took.
struct AlphaBuffer {
  Image<Colour> picture;
  Image<TriangleId> nearest;    ///< the layer in front of each sample; not valid: the background
  std::uint64_t layers = 0;     ///< of all samples
  std::size_t most_layers = 0;  ///< of one sample
  std::size_t bytes = 0;        ///< working storage beside the picture: corners, lists of layers
};

/// The alpha-buffer: a z-buffer that keeps what lies behind, and so the painter's algorithm for each pixel. Each sample has a
/// list of its layers; these are sorted by depth, and their colours laid over one another from far to near, on white.
///
///   (1) the colours of a painter's order (paint(), caster.h), to the byte, where doubles tell the layers and the depths
///       of a sample as they are; of equal depths the one on top is in front. A layer is a triangle: where those of a face
///       that crosses itself lie over one another, each is laid on, while an order paints such a place of a planar face once
///   (2) the same for any order of the triangles, but for equal depths
///
/// @param colours of each face; its opacity is multiplied by `opacity`, 0 ... 1
/// Exact: no. Cost: O(n + layers log layers); one thread, but for the corners.
/// Source: Catmull 1974 names the lists that transparency needs; Porter & Duff 1984, "over".
AlphaBuffer alpha_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                         double opacity, TieRule ties = {});

}  // namespace hsr::internal
