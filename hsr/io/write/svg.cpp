#include "hsr/io/write/svg.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "hsr/io/write/dashes.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_of_id(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-'; }

/// What identifies each object within a layer: its name, with _ for what is no letter, digit, point or dash of ASCII, and a number
/// where two names come to the same.
std::vector<std::string> ids_of(const std::vector<std::string>& names) {
  std::vector<std::string> ids;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string id;
    for (const char c : name) {
      id += is_of_id(c) ? c : '_';
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
  ObjectGroups(const std::vector<std::string>& names, const std::string& id_prefix)
      : names_(names), ids_(ids_of(names)), prefix_(id_prefix) {}

  /// What follows is of this object of that layer. Objects without a name have no group.
  void begin(std::string& out, const std::string& layer, std::uint32_t object) {
    if (object < names_.size() && names_[object].empty()) object = SceneObjects::none;
    if (object == open_) return;
    end(out);
    open_ = object;
    if (object == SceneObjects::none) return;
    out += "<g id=\"" + prefix_ + layer + '-' + ids_[object] + "\" class=\"object\" data-object=\"";
    append_text(out, names_[object]);
    out += "\" inkscape:label=\"";
    append_text(out, names_[object]);
    out += "\">\n";
  }
  void end(std::string& out) {
    if (open_ != SceneObjects::none) out += "</g>\n";
    open_ = SceneObjects::none;
  }

 private:
  const std::vector<std::string>& names_;
  std::vector<std::string> ids_;
  const std::string& prefix_;
  std::uint32_t open_ = SceneObjects::none;
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
    if (fills.rings[r].empty()) continue;
    append_points(out, fills.rings[r]);
    out += 'Z';
  }
}

void append_fill_line(std::string& out, const Fills& fills, const FillLine& line, const Pen& pen) {
  out += "<path d=\"";
  append_points(out, fills.points_of(line));
  out += line.closed ? "Z\" fill=\"none\" stroke=\"" : "\" fill=\"none\" stroke=\"";
  append_colour(out, pen.colour);
  out += "\" stroke-width=\"";
  append_length(out, pen.width);
  out += "\"/>\n";
}

void append_fills(std::string& out, const Fills& fills, const Pens& pens, const std::string& prefix, ObjectGroups& objects) {
  if (fills.fills.empty()) return;
  out += "<g id=\"" + prefix +
         "fills\" class=\"fill\" inkscape:groupmode=\"layer\" inkscape:label=\"fill\" stroke-linejoin=\"round\" "
         "stroke-linecap=\"round\">\n";
  for_each_painted(
      fills,
      [&](std::span<const Fill> sheet) {
        objects.end(out);
        out += "<g class=\"sheet\" opacity=\"";
        append_length(out, std::round(sheet[0].opacity * 1000) / 1000);
        out += "\">\n";
      },
      [&](const Fill& fill, double opacity) {
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
      },
      [&] {
        objects.end(out);
        out += "</g>\n";
      },
      [&](const FillLine& line) { append_fill_line(out, fills, line, pens.of(false, line.edge_class)); });
  objects.end(out);
  out += "</g>\n";
}

/// What a line has instead of its layer's dashes.
void append_dashes(std::string& out, std::span<const double> lengths) {
  out += lengths.size() == 1 ? "\" stroke-dasharray=\"none" : "\" stroke-dasharray=\"";
  if (lengths.size() == 1) return;
  const char* blank = "";
  for (const double length : lengths) {
    out += blank;
    blank = " ";
    append_rounded_length(out, length);
  }
}

/// An arc, in parts of less than half an ellipse: what is told of an arc, its ends and its radii, says best where those run.
void append_arc(std::string& out, const PathPart& arc) {
  for (const PathPart& part : at_most(arc, 2 * std::numbers::pi / 3)) {
    out += 'A';
    append_rounded_length(out, part.arc.long_radius());
    out += ' ';
    append_rounded_length(out, part.arc.short_radius());
    out += ' ';
    append_rounded_length(out, std::atan2(part.arc.long_axis.y, part.arc.long_axis.x) * 180 / std::numbers::pi);
    out += part.arc.sweep() > 0 ? " 0 1 " : " 0 0 ";
    append_coordinate(out, part.to.x);
    out += ' ';
    append_coordinate(out, part.to.y);
  }
}

/// "Mx y x yA...Lx yZ"
void append_path_data(std::string& out, const Path& path) {
  char before = 'M';
  const auto point = [&](const PaperPoint& p) {
    out += before;
    before = ' ';
    append_coordinate(out, p.x);
    out += ' ';
    append_coordinate(out, p.y);
  };
  for_each_part(path, point, point, [&](const PathPart& arc) {
    append_arc(out, arc);
    before = 'L';
  });
  if (path.closed) out += 'Z';
}

void append_path(std::string& out, const Drawing& drawing, const Polyline& p, const Pen& pen) {
  out += "<path d=\"";
  if (pen.is_dashed()) {
    const DashedPath dashed = dashed_path(path_of(drawing, p), pen);
    append_path_data(out, dashed.path);
    append_dashes(out, dashed.lengths);
  } else {
    append_path_data(out, path_of(drawing, p));
  }
  const char* comma = "\" data-edge=\"";  // where faces pierce each other there is no edge
  for (const auto& [i, j] : drawing.edges_of(p)) {
    out += comma;
    comma = ",";
    append_integer(out, i);
    out += '-';
    append_integer(out, j);
  }
  if (!drawing.edges_of(p).empty() || !drawing.faces_of(p).empty()) append_faces(out, drawing.faces_of(p));
  out += "\"/>\n";
}

void append_layer_start(std::string& out, const std::string& prefix, const Layer& layer) {
  const Pen& pen = layer.pen;
  out += "<g id=\"" + prefix + layer.name('-') + "\" class=\"" + layer.name();
  out += "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + layer.name();
  out += "\" fill=\"none\" stroke=\"";
  if (pen.has_colour)
    append_colour(out, pen.colour);
  else
    out += "#000";
  out += "\" stroke-linejoin=\"round\" stroke-linecap=\"";
  out += pen.is_dashed() ? "butt" : "round";
  out += "\" stroke-width=\"";
  append_length(out, pen.width);
  if (pen.is_dashed()) append_dashes(out, pen.dashes);
  out += "\">\n";
}

}  // namespace

void check_id_prefix(const std::string& prefix) {
  const bool is_right = std::ranges::all_of(prefix, [](char c) { return is_of_id(c) || c == '_'; });
  if (!prefix.empty() && (!is_right || !(is_letter(prefix[0]) || prefix[0] == '_')))
    throw InputError("--id-prefix: found \"" + prefix +
                     "\", expected a letter or _, then letters, digits, points, - and _ of ASCII");
}

std::string svg(const Drawing& drawing, const SvgOptions& options) {
  std::string out;
  append_svg_start(out, drawing.width, drawing.height, options);
  const std::string& prefix = options.id_prefix;
  ObjectGroups objects(drawing.objects, prefix);
  append_fills(out, drawing.fills, drawing.pens, prefix, objects);
  for (const Layer& layer : layers_of(drawing)) {
    append_layer_start(out, prefix, layer);
    for (const Polyline& p : layer.polylines) {
      objects.begin(out, layer.name('-'), p.object);
      append_path(out, drawing, p, layer.pen);
    }
    objects.end(out);
    out += "</g>\n";
  }
  out += "</svg>\n";
  return out;
}

}  // namespace hsr::internal
