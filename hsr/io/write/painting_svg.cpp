#include "hsr/io/write/painting_svg.h"

#include <algorithm>
#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"
#include "hsr/io/write/underlay.h"

namespace hsr::internal {

namespace {

constexpr double seam = 0.1, line = 0.25, cut = 0.9;  // mm: the pens of seams, of lines, and of cuts
constexpr double short_of_ends = 500;                 // thousandths: a cut's pen covers no line of the other part

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

/// All pieces, as they are painted, with pens of their own colours, cut to what they cover together: under the pieces, what the
/// pens add shows only where two of them meet within a pixel.
void append_underlay(std::string& out, const Painting& painting, const std::string& clip) {
  out += "<clipPath id=\"outline\"><path clip-rule=\"nonzero\" d=\"";
  std::vector<PaperPoint> turned;
  for (const PaintedPiece& piece : painting.pieces) {
    // All one way round, or what two of them cover would be outside.
    const auto points = painting.points_of(piece);
    turned.assign(points.begin(), points.end());
    double twice = 0;
    for (std::size_t k = 0; k < turned.size(); ++k) {
      const PaperPoint &p = turned[k], &q = turned[(k + 1) % turned.size()];
      twice += static_cast<double>(p.x - turned[0].x) * static_cast<double>(q.y - turned[0].y) -
               static_cast<double>(p.y - turned[0].y) * static_cast<double>(q.x - turned[0].x);
    }
    if (twice == 0) continue;
    if (twice < 0) std::reverse(turned.begin(), turned.end());
    append_points(out, turned);
    out += 'Z';
  }
  out += "\"/></clipPath>\n<g" + clip + "><g class=\"underlay\" clip-path=\"url(#outline)\">\n";
  for (const double width : underlay_widths) {
    out += "<use href=\"#pieces\" xlink:href=\"#pieces\" stroke-width=\"";
    append_length(out, width);
    out += "\"/>\n";
  }
  out += "</g></g>\n";
}

}  // namespace

std::string painting_svg(const Painting& painting, double opacity, const SvgOptions& options) {
  std::string out;
  append_svg_start(out, painting.width, painting.height, options, true);
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
  const bool is_underlaid = opacity >= 1 && std::all_of(painting.pieces.begin(), painting.pieces.end(),
                                                        [](const PaintedPiece& p) { return p.colour[3] == 255; });
  const std::string clip = painting.frame ? " clip-path=\"url(#frame)\"" : "";
  if (is_underlaid) append_underlay(out, painting, clip);
  out += "<g class=\"pieces\" inkscape:groupmode=\"layer\" inkscape:label=\"pieces, far to near\" stroke-width=\"";
  append_length(out, is_underlaid ? 0 : seam);
  out += '"' + clip + "><g id=\"pieces\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
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
  out += "</g></g>\n</svg>\n";
  return out;
}

}  // namespace hsr::internal
