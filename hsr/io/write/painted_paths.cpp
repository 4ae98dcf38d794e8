#include "hsr/io/write/painted_paths.h"

#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

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

void append_rings(std::string& out, const Fills& fills, std::uint32_t first, std::uint32_t end) {
  for (std::uint32_t r = first; r < end; ++r) {
    if (fills.ring(r).empty()) continue;
    append_path(out, fills.ring(r));
    out += "h\n";
  }
}

}  // namespace

double points_of(double mm) { return std::round(mm * 360e9 / 127) / 1e9; }

void append_page_space(std::string& out, double height) {
  append_length(out, points_of(1));
  out += " 0 0 ";
  append_length(out, -points_of(1));
  out += " 0 ";
  append_length(out, points_of(height));
  out += " cm\n1 j\n";
}

void append_fill_paths(std::string& out, const Fills& fills, const char* paint) {
  for (const Fill& fill : fills.fills) {
    std::string colour;
    for (std::size_t k = 0; k < 3; ++k) {
      append_length(colour, std::round(fill.colour[k] / 255.0 * 1e5) / 1e5);
      colour += ' ';
    }
    out += colour + "rg " + colour + "RG\n";
    append_rings(out, fills, fill.first_ring, fill.end_ring);
    out += paint;
    out += '\n';
  }
}

void append_fill_clip(std::string& out, const Fills& fills) {
  append_rings(out, fills, fills.first_outline_ring, fills.rings());
  out += "W* n\n";
}

}  // namespace hsr::internal
