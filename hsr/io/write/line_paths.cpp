#include "hsr/io/write/line_paths.h"

#include <cmath>

#include "hsr/io/write/dashes.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

void append_path(std::string& out, std::span<const PaperPoint> points) {
  const char* operation = " m\n";
  for (const PaperPoint& p : points) {
    append_coordinate(out, p.x);
    out += ' ';
    append_coordinate(out, p.y);
    out += operation;
    operation = " l\n";
  }
}

void append_path(std::string& out, const Path& path, double tolerance) {
  const auto point = [&](const PaperPoint& p, const char* operation) {
    append_coordinate(out, p.x);
    out += ' ';
    append_coordinate(out, p.y);
    out += operation;
  };
  for_each_part(
      path, [&](const PaperPoint& p) { point(p, " m\n"); }, [&](const PaperPoint& p) { point(p, " l\n"); },
      [&](const PathPart& arc) {
        for (const Bezier& curve : beziers(arc, tolerance)) {
          for (const double x : {curve.first.x, curve.first.y, curve.second.x, curve.second.y}) {
            append_rounded_length(out, x);
            out += ' ';
          }
          point(curve.to, " c\n");
        }
      });
}

void append_pen(std::string& out, const Pen& pen) {
  for (std::size_t k = 0; k < 3; ++k) {
    append_length(out, std::round(pen.colour[k] / 255.0 * 1e5) / 1e5);
    out += ' ';
  }
  out += "RG\n";
  append_length(out, pen.width);
  out += pen.is_dashed() ? " w 0 J\n" : " w 1 J\n";
}

void append_line(std::string& out, const Drawing& drawing, const Polyline& line, const Pen& pen) {
  const Path path = path_of(drawing, line);
  if (pen.is_dashed()) {
    for (const Path& dash : dashes_of(dashed_path(path, pen))) append_path(out, dash, drawing.arc_tolerance);
    out += "S\n";
    return;
  }
  append_path(out, path, drawing.arc_tolerance);
  out += line.closed ? "h S\n" : "S\n";
}

}  // namespace hsr::internal
