#include "hsr/io/write/svg.h"

#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/svg_text.h"

namespace hsr {

using namespace internal;

namespace {

/// What identifies each object within a layer: its name, with _ for what is no letter, digit, point or dash of ASCII, and a number
/// where two names come to the same.
std::vector<std::string> ids_of(const std::vector<std::string>& names) {
  std::vector<std::string> ids;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string id;
    for (const char c : name) {
      const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
      id += is_kept ? c : '_';
    }
    const std::string wanted = id;
    for (int k = 2; !taken.insert(id).second; ++k) id = wanted + "__" + std::to_string(k);
    ids.push_back(std::move(id));
  }
  return ids;
}

/// Opens and closes the groups of objects within the layers.
class ObjectGroups {
 public:
  explicit ObjectGroups(const std::vector<std::string>& names) : names_(names), ids_(ids_of(names)) {}

  /// What follows is of this object of that layer. Objects without a name have no group.
  void begin(std::string& out, const std::string& layer, std::uint32_t object) {
    if (object < names_.size() && names_[object].empty()) object = FaceObjects::none;
    if (object == open_) return;
    end(out);
    open_ = object;
    if (object == FaceObjects::none) return;
    out += "<g id=\"" + layer + '-' + ids_[object] + "\" class=\"object\" data-object=\"";
    append_text(out, names_[object]);
    out += "\" inkscape:label=\"";
    append_text(out, names_[object]);
    out += "\">\n";
  }
  void end(std::string& out) {
    if (open_ != FaceObjects::none) out += "</g>\n";
    open_ = FaceObjects::none;
  }

 private:
  const std::vector<std::string>& names_;
  std::vector<std::string> ids_;
  std::uint32_t open_ = FaceObjects::none;
};

void append_faces(std::string& out, std::span<const std::uint32_t> faces) {
  out += "\" data-face=\"";
  const char* comma = "";
  for (const std::uint32_t f : faces) {
    out += comma;
    comma = ",";
    append_integer(out, f);
  }
}

void append_rings(std::string& out, const Fills& fills, const Fill& fill) {
  for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) {
    if (fills.ring(r).empty()) continue;
    append_points(out, fills.ring(r));
    out += 'Z';
  }
}

void append_fill_line(std::string& out, const Fills& fills, const FillLine& line) {
  out += "<path d=\"";
  append_points(out, fills.points_of(line));
  out += line.closed ? "Z\" fill=\"none\" stroke=\"#000\" stroke-width=\"" : "\" fill=\"none\" stroke=\"#000\" stroke-width=\"";
  append_length(out, style_of(line).width);
  out += "\"/>\n";
}

void append_fills(std::string& out, const Fills& fills, ObjectGroups& objects) {
  if (fills.fills.empty()) return;
  out +=
      "<g id=\"fills\" class=\"fill\" inkscape:groupmode=\"layer\" inkscape:label=\"fill\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\">\n";
  const auto append_fill = [&](const Fill& fill, double opacity) {
    objects.begin(out, "fill", fill.object);
    out += "<path d=\"";
    append_rings(out, fills, fill);
    out += "\" fill=\"";
    append_colour(out, fill.colour);
    if (opacity < 1) {
      out += "\" fill-opacity=\"";
      append_length(out, std::round(opacity * 1000) / 1000);
    }
    append_faces(out, {fills.faces.data() + fill.first_face, fills.faces.data() + fill.end_face});
    out += "\"/>\n";
  };
  for_each_painted(
      fills,
      [&](std::span<const Fill> sheet) {
        if (sheet.size() == 1) {
          append_fill(sheet[0], sheet[0].opacity);
          return;
        }
        objects.end(out);
        out += "<g class=\"sheet\" opacity=\"";
        append_length(out, std::round(sheet[0].opacity * 1000) / 1000);
        out += "\">\n";
        for (const Fill& fill : sheet) append_fill(fill, 1);
        objects.end(out);
        out += "</g>\n";
      },
      [&](const FillLine& line) { append_fill_line(out, fills, line); });
  objects.end(out);
  out += "</g>\n";
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

void append_layer_start(std::string& out, const Layer& layer) {
  const LineStyle& style = layer.style;
  out += "<g id=\"" + layer.name('-') + "\" class=\"" + layer.name();
  out += "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + layer.name();
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
  std::string out;
  append_svg_start(out, drawing.width, drawing.height, options);
  ObjectGroups objects(drawing.objects);
  append_fills(out, drawing.fills, objects);
  for (const Layer& layer : layers_of(drawing)) {
    append_layer_start(out, layer);
    for (const Polyline& p : layer.polylines) {
      objects.begin(out, layer.name('-'), p.object);
      append_path(out, drawing, p);
    }
    objects.end(out);
    out += "</g>\n";
  }
  out += "</svg>\n";
  return out;
}

}  // namespace hsr
