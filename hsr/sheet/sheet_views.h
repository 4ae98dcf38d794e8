#pragma once

#include <string>
#include <vector>

#include "hsr/sheet/sheet.h"

namespace hsr::internal {

/// What a view shows, from the origin of its frame, in units of the frame.
struct ViewRectangle {
  double left = 0, right = 0, bottom = 0, top = 0;
};

/// A view of a sheet before it is placed.
struct SheetView {
  std::string name, label;
  View view;
  ViewRectangle rectangle;
  bool is_in_top_row = false;  ///< beside the view from above, else beside the front view
  bool lines_up = true;        ///< with the others of its row
  bool has_hidden_lines = false;
  std::string cut_in;                   ///< of a section: the view that sees it edge-on; empty: none
  const SheetDetail* detail = nullptr;  ///< of a detail
};

/// The views that are asked for, all around the middle of the model: front, top and side, then sections, iso, details.
/// @throws InputError where one is unknown, or nothing is to be seen
std::vector<SheetView> views_of_sheet(const Scene& scene, const SheetOptions& options);

/// "1:2", "2.5:1"
std::string ratio_text(double scale);

/// Appends a view's lines, each visibility and class as a layer of the sheet's drawing.
void append_view(Drawing& sheet, const Drawing& view, const std::string& name);

}  // namespace hsr::internal
