#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// A drawing as a PDF 1.5 file of one page, which looks as the SVG does. A layer (optional content group) for the fills and for each
/// visibility and class that occurs, named as in the SVG; hidden lines first. Where objects are told apart each layer has a layer within it
/// for each of its objects, with the name in the file's words.
///
///   (1) the page is as large as the drawing's, in points of 1/72 inch; coordinates have up to 3 decimals of a millimetre
///   (2) no date and no random number: the same drawing gives the same bytes
///
/// @param title any text; what is not UTF-8 becomes U+FFFD
/// @throws InputError if a side of the page is longer than 5080 mm, which is as far as PDF goes
std::string pdf(const Drawing& drawing, const std::string& title = {});

}  // namespace hsr::internal
