#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "hsr/drawing/page.h"
#include "hsr/drawing/placement.h"
#include "hsr/lines/line_options.h"
#include "hsr/painter/painters_order.h"

namespace hsr::internal {

/// A side of a piece along which a line is drawn.
struct SideLine {
  PaperPoint from, to;
  EdgeClass edge_class = EdgeClass::outline;
};

/// A piece of an order on the paper; nothing of it is left outside the frame.
struct PlacedPiece {
  std::vector<PaperPoint> ring;  ///< fewer corners than three: none
  std::vector<SideLine> lines;
};

/// Places pieces on the page, each corner the exact one rounded to 0.001 mm.
class PiecePlacer {
 public:
  PiecePlacer(const Mesh& mesh, const View& view, const Placement& place)
      : mesh_(mesh), view_(view), projection_(place.projection), frame_(place.frame) {}

  /// A part of a wire: its ends, or nothing where it is outside the frame.
  std::vector<PaperPoint> operator()(const OrderedWire& wire) const;
  /// @param asked by edge: its class if it is drawn; nullptr: none is
  PlacedPiece operator()(const OrderedPiece& piece, std::span<const PieceCorner> corners,
                         const std::vector<std::optional<EdgeClass>>* asked) const;

 private:
  using Wide = Enclosure::Wide;

  bool is_in_frame(const std::array<Wide, 2>& p) const;
  std::optional<EdgeClass> class_of_side(const PieceCorner& corner, const std::vector<std::optional<EdgeClass>>& asked) const;
  void add_clipped(const std::array<Wide, 2>& from, const std::array<Wide, 2>& to, EdgeClass edge_class,
                   std::vector<SideLine>& lines) const;
  PaperPoint rounded(FacetId facet, const PieceCorner& corner, const HomogeneousPoint& at) const;
  HomogeneousPoint enclosed(FacetId facet, const PieceCorner& corner) const;

  const Mesh& mesh_;
  const View& view_;
  const Projection& projection_;
  const std::optional<PaperFrame>& frame_;
};

}  // namespace hsr::internal
