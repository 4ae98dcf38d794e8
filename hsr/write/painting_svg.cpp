#include "hsr/write/painting_svg.h"

#include <cmath>

#include "hsr/write/json_text.h"
#include "hsr/write/svg_text.h"

namespace hsr {

namespace {

constexpr double seam = 0.1, line = 0.25, cut = 0.5;  // mm: the pens of seams, of lines, and of cuts
constexpr double short_of_ends = 300;                 // thousandths: a cut's pen covers no line of the other part

/// A side made shorter at both ends; false: nothing is left.
bool shorten(PaperPoint& p, PaperPoint& q) {
  const auto x = static_cast<double>(q.x - p.x), y = static_cast<double>(q.y - p.y);
  const double length = std::hypot(x, y);
  if (!(length > 2 * short_of_ends)) return false;
  const auto dx = std::llround(x / length * short_of_ends), dy = std::llround(y / length * short_of_ends);
  p = {p.x + dx, p.y + dy};
  q = {q.x - dx, q.y - dy};
  return true;
}

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
  out +=
      "<g class=\"pieces\" inkscape:groupmode=\"layer\" inkscape:label=\"pieces, far to near\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\" stroke-width=\"";
  append_length(out, seam);
  out += '"';
  if (painting.frame) out += " clip-path=\"url(#frame)\"";
  out += ">\n";
  for (const PaintedPiece& piece : painting.pieces) {
    const auto points = painting.points_of(piece);
    const double own_opacity = opacity * piece.colour[3] / 255;
    const bool is_opaque = !(own_opacity < 1);
    out += "<path d=\"";
    append_points(out, points);
    out += "Z\" fill=\"";
    append_colour(out, piece.colour);
    if (is_opaque) {
      out += "\" stroke=\"";
      append_colour(out, piece.colour);
    } else {
      out += "\" fill-opacity=\"";
      append_length(out, std::round(own_opacity * 1000) / 1000);
    }
    out += "\" data-face=\"";
    append_integer(out, piece.face);
    out += "\"/>\n";
    std::string lines, cuts;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const SideOf side = painting.sides[piece.first_point + k];
      PaperPoint ends[2] = {points[k], points[(k + 1) % points.size()]};
      if (side == SideOf::line) append_points(lines, ends);
      // What was painted between the two parts may reach over the cut, with half a pen: this part covers it.
      if (side == SideOf::cut && is_opaque && shorten(ends[0], ends[1])) append_points(cuts, ends);
    }
    if (!cuts.empty()) {
      out += "<path d=\"" + cuts + "\" fill=\"none\" stroke-linecap=\"butt\" stroke=\"";
      append_colour(out, piece.colour);
      out += "\" stroke-width=\"";
      append_length(out, cut);
      out += "\"/>\n";
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
