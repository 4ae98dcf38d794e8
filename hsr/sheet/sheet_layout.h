#pragma once

#include <optional>
#include <vector>

#include "geometry/point.h"
#include "hsr/sheet/sheet.h"

namespace hsr::internal {

/// A view to be placed. Its first row is that of the front view, its second that of the view from above.
struct ViewToPlace {
  enum class Row : unsigned char { of_front, of_top };

  Row row = Row::of_front;
  /// How far what it shows reaches from the origin of its frame, mm at the scale 1:1, or on paper.
  double left = 0, right = 0, above = 0, below = 0;
  bool is_on_paper = false;
  /// In a row those that line up have their origins at one height; the first of each row are one above the other.
  bool lines_up = true;
  bool is_free = false;  ///< it goes into either row, wherever a larger scale can be had
  double pad_left = 0, pad_right = 0, pad_above = 0, pad_below = 0;  ///< mm of paper around it, for dimensions and letters
};

struct SheetLayout {
  double scale = 1;             ///< paper length over model length
  std::vector<Point2> origins;  ///< mm on the page, by view
};

/// Places the views in two rows, that of the front view above the other in first angle and below it in third, free of the title block.
/// @param area what they may cover @param scale nothing: the largest of ISO 5455 at which all fit
/// @return nothing where they do not fit at the scale
std::optional<SheetLayout> lay_out(std::vector<ViewToPlace> views, const PaperFrame& area, const PaperFrame& title_block,
                                   ProjectionAngle angle, std::optional<double> scale);

}  // namespace hsr::internal
