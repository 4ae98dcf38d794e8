#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// A drawing as Encapsulated PostScript, level 2, with the paths of the PDF; comments name the layers, and in them the objects
/// where these are told apart. The bounding box is the page.
/// @param title what is not printable ASCII becomes "?"
std::string eps(const Drawing& drawing, const std::string& title = {});

}  // namespace hsr::internal
