#include "hsr/write/painting_svg.h"

#include "hsr/write/json_text.h"
#include "hsr/write/svg_text.h"

namespace hsr {

namespace {

constexpr double seam = 0.1, line = 0.25;  // mm: the pens of seams and of lines

}  // namespace

std::string painting_svg(const Painting& painting, double opacity, const SvgOptions& options) {
  std::string out;
  append_svg_start(out, painting.width, painting.height, options);
  if (painting.frame) {
    const PaperFrame& f = *painting.frame;
    out += "<clipPath id=\"frame\"><rect x=\"";
    append_length(out, f.left);
    out += "\" y=\"";
    append_length(out, f.top);
    out += "\" width=\"";
    append_length(out, f.right - f.left);
    out += "\" height=\"";
    append_length(out, f.bottom - f.top);
    out += "\"/></clipPath>\n";
  }
  const bool is_opaque = !(opacity < 1);
  out +=
      "<g class=\"pieces\" inkscape:groupmode=\"layer\" inkscape:label=\"pieces, far to near\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\" stroke-width=\"";
  append_length(out, is_opaque ? seam : 0);
  out += '"';
  if (painting.frame) out += " clip-path=\"url(#frame)\"";
  if (!is_opaque) {
    out += " fill-opacity=\"";
    append_length(out, opacity);
    out += '"';
  }
  out += ">\n";
  for (const PaintedPiece& piece : painting.pieces) {
    const auto points = painting.points_of(piece);
    out += "<path d=\"";
    append_points(out, points);
    out += "Z\" fill=\"";
    append_colour(out, piece.colour);
    if (is_opaque) {
      out += "\" stroke=\"";
      append_colour(out, piece.colour);
    }
    out += "\" data-face=\"";
    append_integer(out, piece.face);
    out += "\"/>\n";
    std::string lines;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (painting.is_line[piece.first_point + k] == 0) continue;
      const PaperPoint ends[2] = {points[k], points[(k + 1) % points.size()]};
      append_points(lines, ends);
    }
    if (lines.empty()) continue;
    out += "<path d=\"" + lines + "\" fill=\"none\" stroke=\"#000000\" stroke-width=\"";
    append_length(out, line);
    out += "\"/>\n";
  }
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace hsr
