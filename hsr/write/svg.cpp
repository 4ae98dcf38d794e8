#include "hsr/write/svg.h"

#include <charconv>
#include <span>

#include "hsr/write/json.h"
#include "hsr/write/json_text.h"
#include "hsr/write/line_style.h"

namespace hsr {

namespace {

/// Thousandths as a decimal without trailing zeros.
void append_coordinate(std::string& out, std::int64_t thousandths) {
  if (thousandths < 0) out += '-';
  const std::uint64_t magnitude =
      thousandths < 0 ? 0 - static_cast<std::uint64_t>(thousandths) : static_cast<std::uint64_t>(thousandths);
  append_integer(out, magnitude / 1000);
  auto rest = static_cast<unsigned>(magnitude % 1000);
  if (rest == 0) return;
  out += '.';
  for (unsigned place = 100; rest != 0; place /= 10) {
    out += static_cast<char>('0' + rest / place);
    rest %= place;
  }
}

void append_length(std::string& out, double mm) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, mm, std::chars_format::fixed);
  out.append(text, end);
}

/// Text as XML: what XML 1.0 cannot carry becomes U+FFFD, malformed UTF-8 too.
void append_text(std::string& out, const std::string& text) {
  static constexpr const char* replacement = "\xEF\xBF\xBD";
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80                ? 1
                               : c >= 0xC2 && c < 0xE0 ? 2
                               : c >= 0xE0 && c < 0xF0 ? 3
                               : c >= 0xF0 && c < 0xF5 ? 4
                                                       : 0;
    bool good = length > 0 && i + length <= text.size();
    std::uint32_t code = length == 1 ? c : c & (0xFFU >> (length + 1));
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = (next & 0xC0U) == 0x80U;
      code = code << 6 | (next & 0x3FU);
    }
    static constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    good = good && code >= least[length] && code <= 0x10FFFF && !(code >= 0xD800 && code < 0xE000) && code != 0xFFFE &&
           code != 0xFFFF && (code >= 0x20 || code == '\t' || code == '\n');
    if (!good) {
      out += replacement;
      ++i;
      continue;
    }
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out.append(text, i, length);
    i += length;
  }
}

void append_points(std::string& out, std::span<const PaperPoint> points) {
  out += 'M';
  bool first = true;
  for (const PaperPoint& point : points) {
    if (!first) out += ' ';
    first = false;
    append_coordinate(out, point.x);
    out += ' ';
    append_coordinate(out, point.y);
  }
}

void append_faces(std::string& out, std::span<const std::uint32_t> faces) {
  out += "\" data-face=\"";
  const char* comma = "";
  for (const std::uint32_t f : faces) {
    out += comma;
    comma = ",";
    append_integer(out, f);
  }
}

void append_colour(std::string& out, const Colour& colour) {
  static constexpr const char* digits = "0123456789abcdef";
  out += '#';
  for (std::size_t k = 0; k < 3; ++k) {
    out += digits[colour[k] / 16];
    out += digits[colour[k] % 16];
  }
}

/// The fills, and under them again, with pens of their own colours, cut to the outline of all: what the pens add lies under the
/// fills, but where two meet within a pixel.
void append_fills(std::string& out, const Fills& fills) {
  if (fills.fills.empty()) return;
  out += "<clipPath id=\"outline\"><path clip-rule=\"evenodd\" d=\"";
  for (std::uint32_t r = fills.first_outline_ring; r < fills.rings(); ++r) {
    if (fills.ring(r).empty()) continue;
    append_points(out, fills.ring(r));
    out += 'Z';
  }
  out += "\"/></clipPath>\n<g class=\"underlay\" clip-path=\"url(#outline)\">\n";
  for (const double width : underlay_widths) {
    out += "<use href=\"#fills\" xlink:href=\"#fills\" stroke-width=\"";
    append_length(out, width);
    out += "\"/>\n";
  }
  out +=
      "</g>\n<g class=\"fill\" inkscape:groupmode=\"layer\" inkscape:label=\"fill\" stroke-width=\"0\">"
      "<g id=\"fills\" fill-rule=\"evenodd\" stroke-linejoin=\"round\">\n";
  for (const Fill& fill : fills.fills) {
    out += "<path d=\"";
    for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) {
      if (fills.ring(r).empty()) continue;
      append_points(out, fills.ring(r));
      out += 'Z';
    }
    out += "\" fill=\"";
    append_colour(out, fill.colour);
    out += "\" stroke=\"";
    append_colour(out, fill.colour);
    append_faces(out, {fills.faces.data() + fill.first_face, fills.faces.data() + fill.end_face});
    out += "\"/>\n";
  }
  out += "</g></g>\n";
}

void append_path(std::string& out, const Drawing& drawing, const Polyline& p) {
  out += "<path d=\"";
  append_points(out, drawing.points_of(p));
  if (p.closed) out += 'Z';
  const char* comma = "\" data-edge=\"";  // where faces pierce each other there is no edge
  for (const auto& [i, j] : drawing.edges_of(p)) {
    out += comma;
    comma = ",";
    append_integer(out, i);
    out += '-';
    append_integer(out, j);
  }
  append_faces(out, drawing.faces_of(p));
  out += "\"/>\n";
}

void append_layer_start(std::string& out, const Polyline& p, HiddenLines hidden_lines) {
  const std::string visibility = p.hidden ? "hidden" : "visible", edge_class = name_of(p.edge_class);
  const LineStyle style = line_style(p.hidden, p.edge_class, hidden_lines);
  out += "<g id=\"" + visibility + '-' + edge_class + "\" class=\"" + visibility + ' ' + edge_class;
  out += "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + visibility + ' ' + edge_class;
  out += "\" fill=\"none\" stroke=\"#000\" stroke-linejoin=\"round\" stroke-linecap=\"";
  out += style.is_dashed() ? "butt" : "round";
  out += "\" stroke-width=\"";
  append_length(out, style.width);
  if (style.is_dashed()) {
    out += "\" stroke-dasharray=\"";
    append_length(out, style.dash);
    out += ' ';
    append_length(out, style.gap);
  }
  out += "\">\n";
}

}  // namespace

std::string svg(const Drawing& drawing, const SvgOptions& options) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" ";
  if (!drawing.fills.fills.empty()) out += "xmlns:xlink=\"http://www.w3.org/1999/xlink\" ";
  out += "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
  append_length(out, drawing.width);
  out += "mm\" height=\"";
  append_length(out, drawing.height);
  out += "mm\" viewBox=\"0 0 ";
  append_length(out, drawing.width);
  out += ' ';
  append_length(out, drawing.height);
  out += "\">\n";
  if (!options.title.empty()) {
    out += "<title>";
    append_text(out, options.title);
    out += "</title>\n";
  }
  if (!options.description.empty()) {
    out += "<desc>";
    append_text(out, options.description);
    out += "</desc>\n";
  }
  append_fills(out, drawing.fills);
  const Polyline* last = nullptr;
  for (const Polyline& p : drawing.polylines) {
    if (last == nullptr || last->hidden != p.hidden || last->edge_class != p.edge_class) {
      if (last != nullptr) out += "</g>\n";
      append_layer_start(out, p, drawing.hidden);
    }
    last = &p;
    append_path(out, drawing, p);
  }
  if (last != nullptr) out += "</g>\n";
  out += "</svg>\n";
  return out;
}

}  // namespace hsr
