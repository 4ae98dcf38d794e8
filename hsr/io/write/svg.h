#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

struct SvgOptions {
  std::string title = {};        ///< any text; escaped
  std::string description = {};  ///< of the view, say
  /// What each id begins with, so that several files can be parts of one document; letters, digits, "-", "_" and ".", first a letter.
  std::string id_prefix = {};
};

/// @throws InputError if ids cannot begin so
void check_id_prefix(const std::string& prefix);

/// A drawing as SVG: millimetres; for each visibility and class that occurs one Inkscape layer, with the CSS classes "visible"
/// or "hidden" and the name of the class; hidden layers first. A path carries its edges and faces in data-edge ("i-j,k-l") and
/// data-face ("f,g"). Coordinates have up to 3 decimals.
///
/// Where objects are told apart (DrawingOptions::objects) there is a group for each within each layer, with its name in the
/// file's words as data-object and Inkscape's label; what is of several objects follows without a group.
std::string svg(const Drawing& drawing, const SvgOptions& options = {});

}  // namespace hsr::internal
