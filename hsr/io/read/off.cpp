#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/io/read/byte_scanner.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/material_library.h"
#include "hsr/io/read/model_builder.h"
#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

constexpr TextScanner::Syntax off_syntax = {.comment = '#', .continuation = false};

/// The keyword: [ST][C][N][4][n]OFF in any order of the letters. Where OFF is not in capitals none of the letters' cases counts.
struct Keyword {
  std::string name;
  bool texture = false, colour = false, normal = false, four = false, n_dimensional = false;
};

std::optional<Keyword> parse_keyword(std::string_view given) {
  if (given.size() < 3 || given.size() > 8) return {};
  std::string word(given);
  if (!word.ends_with("OFF"))
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  if (!word.ends_with("OFF")) return {};
  Keyword k{.name = word};
  for (std::string_view letters = std::string_view(word).substr(0, word.size() - 3); !letters.empty();) {
    const std::size_t used = letters.substr(0, 2) == "ST" ? 2 : 1;
    bool* const flag = used == 2           ? &k.texture
                       : letters[0] == 'C' ? &k.colour
                       : letters[0] == 'N' ? &k.normal
                       : letters[0] == '4' ? &k.four
                       : letters[0] == 'n' ? &k.n_dimensional
                                           : nullptr;
    if (flag == nullptr || *flag) return {};
    *flag = true;
    letters.remove_prefix(used);
  }
  return k;
}

/// Geomview's rule: all within 0 ... 1 is a fraction, else it is of 255. Fewer than three numbers name a colour map.
std::optional<Colour> face_colour(const double* c, std::size_t n) {
  if (n < 3) return {};
  const bool fractions = std::all_of(c, c + n, [](double x) { return x >= 0 && x <= 1; });
  Colour colour = {0, 0, 0, 255};
  for (std::size_t i = 0; i < n; ++i) colour[i] = colour_byte(fractions ? c[i] : c[i] / 255);
  return colour;
}

/// The numbers behind the coordinates of a vertex, as far as they are numbers: normal, colour, texture.
void read_more(TextScanner& text, const Keyword& keyword, ModelBuilder& model) {
  std::array<double, 9> more;
  std::size_t n = 0;
  while (n < more.size()) {
    const std::optional<double> x = text.number_if_any();
    if (!x) break;
    more[n++] = *x;
  }
  const std::size_t before = keyword.normal ? 3 : 0, behind = keyword.texture ? 2 : 0;
  if (keyword.colour && n >= before + 3 + behind)
    model.corner_colours().set(model.points().size() - 1, more.data() + before, std::min<std::size_t>(n - before - behind, 4));
  text.next_line();
}

struct Counts {
  std::uint64_t vertices = 0, faces = 0;
};

/// What both the text and the binary form do with a face once its corners are there.
void end_face(ModelBuilder& model, std::size_t& without_area) {
  const std::size_t n = model.corners_of_open_face();
  if (n == 2) model.add_segment(model.open_corner(0), model.open_corner(1));
  if (n < 2) ++without_area;
  model.end_face();  // those of fewer than three corners too: they keep their number
}

Model finish(ModelBuilder& model, std::size_t without_area) {
  if (without_area != 0) model.note(std::to_string(without_area) + " faces with fewer than 2 corners have nothing to draw");
  return model.finish();
}

Model read_text(const Source& source, TextScanner& text, const Keyword& keyword, const std::string& format) {
  ModelBuilder model(source, format);
  const auto count = [&](const char* expected) {
    if (!text.skip_lines()) text.refuse_here(expected);
    const char* const start = text.position();
    const std::int64_t n = text.integer(expected);
    if (n < 0) text.refuse(start, expected);
    return static_cast<std::uint64_t>(n);
  };
  Counts counts;
  if (!text.skip_lines()) text.refuse_here("the number of vertices");
  const char* const counts_at = text.position();
  counts.vertices = count("the number of vertices");
  counts.faces = count("the number of faces");
  if (!text.at_line_end()) text.integer("the number of edges");
  if (!text.at_line_end()) text.refuse_here("the end of the line after the counts");
  // Six bytes are the shortest vertex, two the shortest face.
  if (counts.vertices > text.bytes_left() / 6 + 1 || counts.faces > text.bytes_left() / 2 + 1)
    text.refuse(counts_at, std::to_string(counts.vertices) + " vertices and " + std::to_string(counts.faces) + " faces",
                "no more than fit into the " + std::to_string(text.bytes_left()) + " bytes that follow");

  const bool more_on_line = keyword.texture || keyword.colour || keyword.normal;
  model.points().reserve(counts.vertices);
  for (std::uint64_t v = 0; v < counts.vertices; ++v) {
    double c[3];
    for (double& x : c) {
      if (!text.skip_lines())
        text.refuse_here("coordinate of vertex " + std::to_string(v) + " of " + std::to_string(counts.vertices));
      x = text.number("a coordinate");
    }
    model.add_point(c[0], c[1], c[2]);
    if (more_on_line)
      read_more(text, keyword, model);
    else if (!text.at_line_end())
      text.refuse_here("the end of the line after 3 coordinates (colours need COFF, normals NOFF)");
  }
  std::size_t without_area = 0;
  for (std::uint64_t f = 0; f < counts.faces; ++f) {
    if (!text.skip_lines()) text.refuse_here("face " + std::to_string(f) + " of " + std::to_string(counts.faces));
    const char* const start = text.position();
    const std::int64_t n = text.integer("the number of corners");
    if (n < 0 || static_cast<std::uint64_t>(n) > text.bytes_left() / 2 + 1)
      text.refuse(start, "a number of corners that fits into the file");
    for (std::int64_t k = 0; k < n; ++k) {
      if (!text.skip_lines()) text.refuse_here("corner " + std::to_string(k) + " of " + std::to_string(n));
      const char* const at = text.position();
      const std::int64_t i = text.integer("the index of a vertex");
      if (i < 0 || i >= static_cast<std::int64_t>(counts.vertices))
        text.refuse(at, counts.vertices == 0 ? std::string("no face without vertices")
                                             : "an index from 0 to " + std::to_string(counts.vertices - 1));
      model.add_corner(static_cast<std::uint32_t>(i));
    }
    double colour[4];
    std::size_t numbers = 0;
    while (!text.at_line_end() && numbers < 4) colour[numbers++] = text.number("a colour");
    if (!text.at_line_end()) text.refuse_here("the end of the line after a colour of 4 numbers");
    model.set_colour(face_colour(colour, numbers));
    end_face(model, without_area);
  }
  if (text.skip_lines()) model.note("line " + std::to_string(text.line()) + ": what follows the last face is passed over");
  return finish(model, without_area);
}

Model read_binary(const Source& source, std::size_t first_byte, const Keyword& keyword, const std::string& format) {
  ModelBuilder model(source, format + " binary");
  ByteScanner bytes(source, first_byte, ByteOrder::big);
  bytes.need(12, "the numbers of vertices, faces and edges");
  Counts counts;
  counts.vertices = bytes.get<std::uint32_t>();
  counts.faces = bytes.get<std::uint32_t>();
  bytes.skip(4);
  const std::size_t stride = 4 * (3 + (keyword.normal ? 3U : 0U) + (keyword.colour ? 4U : 0U) + (keyword.texture ? 2U : 0U));
  if (counts.vertices > bytes.left() / stride || counts.faces > (bytes.left() - counts.vertices * stride) / 8)
    bytes.refuse(first_byte, std::to_string(counts.vertices) + " vertices and " + std::to_string(counts.faces) + " faces",
                 "no more than fit into the " + std::to_string(bytes.left()) + " bytes that follow");
  model.points().reserve(counts.vertices);
  for (std::uint64_t v = 0; v < counts.vertices; ++v) {
    double c[3];
    for (double& x : c) {
      x = bytes.get<float>();
      if (!std::isfinite(x)) bytes.refuse_vertex(v, x);
    }
    model.add_point(c[0], c[1], c[2]);
    if (keyword.normal) bytes.skip(12);
    if (keyword.colour) {
      double rgba[4];
      for (double& x : rgba) x = bytes.get<float>();
      model.corner_colours().set(v, rgba, 4);
    }
    if (keyword.texture) bytes.skip(8);
  }
  std::size_t without_area = 0;
  for (std::uint64_t f = 0; f < counts.faces; ++f) {
    const std::string where = "face " + std::to_string(f);
    bytes.need(4, where);
    const std::size_t at = bytes.offset();
    const auto n = bytes.get<std::uint32_t>();
    if (n > bytes.left() / 4)
      bytes.refuse(at, where + " with " + std::to_string(n) + " corners", "no more than fit into the rest of the file");
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto i = bytes.get<std::int32_t>();
      if (i < 0 || static_cast<std::uint32_t>(i) >= counts.vertices) bytes.refuse_index(f, i, counts.vertices);
      model.add_corner(static_cast<std::uint32_t>(i));
    }
    bytes.need(4, "the colour of " + where);
    const std::size_t colour_at = bytes.offset();
    const auto numbers = bytes.get<std::uint32_t>();
    if (numbers > 4) bytes.refuse(colour_at, "a colour of " + std::to_string(numbers) + " numbers", "4 or fewer");
    bytes.need(4 * numbers, "the colour of " + where);
    double colour[4];
    for (std::uint32_t k = 0; k < numbers; ++k) colour[k] = bytes.get<float>();
    model.set_colour(face_colour(colour, numbers));
    end_face(model, without_area);
  }
  if (bytes.left() != 0) model.note("the last " + std::to_string(bytes.left()) + " bytes belong to no face");
  return finish(model, without_area);
}

}  // namespace

bool looks_like_off(const Source& source) {
  TextScanner text(source, off_syntax);
  return text.skip_lines() && parse_keyword(text.word());
}

Model read_off(const Source& source) {
  TextScanner text(source, off_syntax);
  if (!text.skip_lines()) text.refuse_here("OFF");
  const char* const start = text.position();
  const std::string_view word = text.word();
  std::optional<Keyword> keyword = parse_keyword(word);
  if (!keyword) {
    // The keyword may be left out; then the counts come first.
    if (word.find_first_not_of("0123456789") != std::string_view::npos) text.refuse(start, "OFF, COFF, NOFF, ...");
    keyword = Keyword{.name = "OFF"};
    text.move_to(start);
  }
  if (keyword->four) text.refuse(start, "a format with 3 coordinates (4OFF has 4)");
  if (keyword->n_dimensional) text.refuse(start, "a format with 3 coordinates (nOFF has a number of its own)");
  const char* const after = text.position();
  if (const std::string_view next = text.word(); next == "BINARY" || next == "binary" || next == "Binary") {
    text.next_line();
    return read_binary(source, text.offset(), *keyword, keyword->name);
  }
  text.move_to(after);
  return read_text(source, text, *keyword, keyword->name);
}

}  // namespace hsr::internal::read
