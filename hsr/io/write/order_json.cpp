#include <tbb/parallel_for.h>

#include <algorithm>

#include "hsr/io/write/json.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/section_json.h"

namespace hsr {

using namespace internal;

namespace {

void append_coordinate(std::string& out, const Rational& x, Numbers numbers) {
  // Of most corners of cut pieces the denominator is no power of two: then x is no double.
  const mpz_srcptr denominator = mpq_denref(x.get());
  const bool is_dyadic = mpz_scan1(denominator, 0) + 1 == mpz_sizeinbase(denominator, 2);
  const double rounded = is_dyadic ? x.to_double() : 0;
  const bool is_double = is_dyadic && std::isfinite(rounded) && Rational(rounded) == x;
  append_rational(out, x, is_double ? numbers : Numbers::exact);
}

void append_piece(std::string& out, const Mesh& mesh, const View& view, const PaintersOrder& order, const OrderedPiece& piece,
                  Numbers numbers) {
  out += "{\"face\": ";
  append_integer(out, mesh.face_of[first_triangle(piece.facet)].value);
  out += ", \"points\": [";
  const char* comma = "";
  for (const PieceCorner& corner : order.corners_of(piece)) {
    out += comma;
    comma = ", ";
    if (corner.vertex.is_valid()) {
      append_point(out, mesh.points[corner.vertex], numbers);
      continue;
    }
    const auto p = exact_point(mesh, view, piece.facet, corner);
    for (std::size_t k = 0; k < 3; ++k) {
      out += k == 0 ? "[" : ", ";
      append_coordinate(out, p[k], numbers);
    }
    out += ']';
  }
  out += "], \"original\": [";
  comma = "";
  for (const PieceCorner& corner : order.corners_of(piece)) {
    out += comma;
    comma = ", ";
    out += corner.original ? "true" : "false";
  }
  out += "]}";
}

void append_wire(std::string& out, const Mesh& mesh, const OrderedWire& wire, Numbers numbers) {
  out += "{\"wire\": [";
  append_integer(out, mesh.edges[wire.edge].a.value);
  out += ", ";
  append_integer(out, mesh.edges[wire.edge].b.value);
  out += "], \"points\": [";
  const char* comma = "";
  for (const auto& p : exact_ends(mesh, wire)) {
    out += comma;
    comma = ", ";
    for (std::size_t k = 0; k < 3; ++k) {
      out += k == 0 ? "[" : ", ";
      append_coordinate(out, p[k], numbers);
    }
    out += ']';
  }
  out += "]}";
}

}  // namespace

std::string order_json(const Mesh& mesh, const View& view, const PaintersOrder& order, Numbers numbers, Coplanar coplanar,
                       const Section* section) {
  constexpr std::size_t chunk = 1024;
  // Each piece after the wires that come before it, and what comes after the last.
  std::vector<std::string> parts(order.pieces.size() / chunk + 1);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    auto wire = std::ranges::lower_bound(order.wires, p * chunk, {}, &OrderedWire::before);
    for (std::size_t i = p * chunk; i <= std::min(order.pieces.size(), (p + 1) * chunk - 1); ++i) {
      for (; wire != order.wires.end() && wire->before == i; ++wire) {
        parts[p] += ",\n";
        append_wire(parts[p], mesh, *wire, numbers);
      }
      if (i == order.pieces.size()) break;
      parts[p] += ",\n";
      append_piece(parts[p], mesh, view, order, order.pieces[i], numbers);
    }
  });
  std::string out = "{\"format\": \"hsr-order/1\", \"view\": " + view_json(view, numbers);
  if (coplanar == Coplanar::last) out += ", \"coplanar\": \"last\"";
  out += ", \"pieces\": [\n";
  const std::size_t begin = out.size();
  for (const std::string& part : parts) out += part;
  if (out.size() > begin) out.erase(begin, 2);  // the comma before the first
  out += "\n]";
  if (section != nullptr) append_section(out, *section, numbers);
  out += "}\n";
  return out;
}

}  // namespace hsr
