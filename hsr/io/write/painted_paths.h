#pragma once

#include <functional>
#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Paths in the operators of PDF (m, l, c, h, S, f*, w, J, j, d, rg, ...), appended to a string: the contents of a PDF page, and of an
/// EPS file, whose prologue gives PostScript the same words.

/// Coordinates become millimetres of the page, y down, and joins round, from here on.
void append_page_space(std::string& out, double height);
/// The fills and the lines between them as they are painted. Where the opacity changes, the graphics state of that name follows.
/// @param sheet keeps operators that are painted together, within a frame, and says what paints them
void append_fills(std::string& out, const Fills& fills, const Pens& pens,
                  const std::function<std::string(const std::string&, const PaperFrame&)>& sheet);
std::string name_of_opacity(double opacity);  ///< in thousandths: /O500

/// A length of the page in points, 1/72 inch: whole ones to the last bit, so that no reader rounds up to a pixel more.
double points_of(double mm);

}  // namespace hsr::internal
