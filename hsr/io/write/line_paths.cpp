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
  if (pen.is_dashed()) {
    for (const auto& dash : dashes_of(dashed_path(drawing.points_of(line), line.closed, pen))) append_path(out, dash);
    out += "S\n";
    return;
  }
  append_path(out, drawing.points_of(line));
  out += line.closed ? "h S\n" : "S\n";
}

}  // namespace hsr::internal
