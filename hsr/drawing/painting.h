#pragma once

#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/model.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr {

struct PaintingOptions {
  double opacity = 1;  ///< of every face, times its own
  /// Lines are painted with the pieces beside them, and what is painted later covers them, right or wrong. Without it that is so
  /// only where something is seen through; of opaque pieces all visible lines lie on top.
  bool paints_lines_with_pieces = false;
};

/// A painting order on a page: the pieces as fills, far to near, each corner the exact one rounded to 0.001 mm.
///
/// Where something is seen through, pieces that do not overlap form a layer (as early as what they cover allows), the layers are
/// painted one after the other, and see-through neighbours of one colour in a layer are one fill: so no seam shows between them.
/// Between see-through ones of different colours in one layer a viewer that smooths edges shows a fine one.
///
/// @param colours by FaceId
/// @param lines which edges are drawn
/// @throws InputError as draw() does
/// Cost: O(n log n), and for see-through pieces that of finding which overlap.
Drawing paint_on_page(const SceneView& scene, const PaintersOrder& order, const std::vector<Colour>& colours,
                      const LineOptions& lines, const DrawingOptions& options, const PaintingOptions& painting = {});
/// Of a scene that nothing else looks at.
inline Drawing paint_on_page(const Mesh& mesh, const View& view, const PaintersOrder& order, const std::vector<Colour>& colours,
                             const LineOptions& lines, const DrawingOptions& options, const PaintingOptions& painting = {}) {
  return paint_on_page(SceneView(mesh, view), order, colours, lines, options, painting);
}

}  // namespace hsr
