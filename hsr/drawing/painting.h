#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/model.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// A piece on the page.
struct PaintedPiece {
  std::uint32_t face = 0;
  Colour colour = {};
  std::uint32_t first_point = 0, end_point = 0;
};

/// What is drawn along a side of a piece.
enum class SideOf : std::uint8_t {
  face,  ///< an edge that is not asked for: nothing
  line,  ///< an edge that is
  cut,   ///< where the face was cut: the other part lies on the other side
};

/// A painting order placed on a page, far to near.
struct Painting {
  double width = 0, height = 0;  ///< of the page, mm
  double scale = 1;              ///< mm to a unit of the frame
  bool fits = true;
  std::optional<PaperFrame> frame;  ///< what is outside is cut off
  std::vector<PaintedPiece> pieces;
  std::vector<PaperPoint> points;
  std::vector<SideOf> sides;  ///< by point: of the side from here to the next corner

  std::span<const PaperPoint> points_of(const PaintedPiece& p) const {
    return {points.data() + p.first_point, points.data() + p.end_point};
  }
};

/// Places each corner, correctly rounded to 0.001 mm. A side is a line where it lies on an edge of the face that is of the
/// classes asked for, whole or in part: sides that cuts made never are.
/// @throws InputError as draw() does
Painting paint_on_page(const SceneView& scene, const PaintersOrder& order, const std::vector<Colour>& colours,
                       const LineOptions& lines, const DrawingOptions& options);
/// Of a scene that nothing else looks at.
inline Painting paint_on_page(const Mesh& mesh, const View& view, const PaintersOrder& order,
                              const std::vector<Colour>& colours, const LineOptions& lines, const DrawingOptions& options) {
  return paint_on_page(SceneView(mesh, view), order, colours, lines, options);
}

}  // namespace hsr
