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

/// A picture with softened edges and transparent faces, and what it took.
struct ABuffer {
  Image<Colour> picture;
  std::uint64_t fragments = 0;     ///< of all pixels
  std::size_t most_fragments = 0;  ///< of one pixel
  std::size_t bytes = 0;           ///< working storage beside the picture: corners, lists of fragments
};

/// The A-buffer: anti-aliased, area-averaged, accumulation. The pixel around each sample has a list of fragments, each the part
/// of a face within the pixel: a mask of 4 rows of 8 bits, colour, opacity and depth. A pixel is resolved front to back: what
/// the nearest fragment covers has its colour over that of the others there, the rest is left to the others.
///
///   (1) where the order of the fragments of a pixel is one order for all of it, the mean of the colours of 8 x 4 samples
///   (2) opaque fragments that cover a pixel end its list: what is behind them is never looked at
///
/// Fragments are in the order of their mean depths, of equal ones the one on top first; where faces pierce each other within a pixel one of them has it all.
/// (Carpenter estimates shares from the range of depths; within a pixel neither is right.)
/// @param colours of each face; its opacity is multiplied by `opacity`, 0 ... 1
/// Exact: no. Cost: O(n + fragments log fragments); one thread, but for the corners.
/// Source: Carpenter 1984.
ABuffer a_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                 double opacity, TieRule ties = {});

}  // namespace hsr::internal
