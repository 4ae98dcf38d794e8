#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Paths in the operators of PDF (m, l, h, S, f*, w, J, j, d, rg, ...), appended to a string: the contents of a PDF page, and of an
/// EPS file, whose prologue gives PostScript the same words.

/// Coordinates become millimetres of the page, y down, and joins round, from here on.
void append_page_space(std::string& out, double height);
/// The fills with their own colours, each with `paint` at its end: "f*", or "B*" to draw their borders, too.
void append_fill_paths(std::string& out, const Fills& fills, const char* paint);
/// From here on only what the fills cover together is painted.
void append_fill_clip(std::string& out, const Fills& fills);

/// A length of the page in points, 1/72 inch: whole ones to the last bit, so that no reader rounds up to a pixel more.
double points_of(double mm);

}  // namespace hsr::internal
