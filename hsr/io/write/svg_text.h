#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hsr/drawing/page.h"
#include "hsr/io/write/svg.h"
#include "hsr/model.h"

namespace hsr::internal {

/// SVG text, appended to a string.
void append_coordinate(std::string& out, std::int64_t thousandths);  ///< a decimal without trailing zeros
void append_length(std::string& out, double mm);
void append_rounded_length(std::string& out, double mm);  ///< to 0.0001 mm
/// As XML: what XML 1.0 cannot carry becomes U+FFFD, malformed UTF-8 too.
void append_text(std::string& out, const std::string& text);
void append_points(std::string& out, std::span<const PaperPoint> points);  ///< "Mx y x y"
void append_colour(std::string& out, const Colour& colour);                ///< "#rrggbb"
/// The first element, title and description.
void append_svg_start(std::string& out, double width, double height, const SvgOptions& options);

}  // namespace hsr::internal
