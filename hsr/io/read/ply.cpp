#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hsr/io/read/byte_scanner.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/material_library.h"
#include "hsr/io/read/model_builder.h"
#include "hsr/io/read/ply_header.h"
#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

/// The body as text: one row a line.
class AsciiRows {
 public:
  AsciiRows(const Source& source, std::size_t body) : text_(source, {}, body) {}

  void begin_row(const std::string& element, std::uint64_t row, std::uint64_t count) {
    while (text_.skip_lines() && *text_.position() == 'c') {
      const char* const at = text_.position();
      if (text_.word() != "comment") text_.refuse(at, "a number, or a comment");
      text_.next_line();
    }
    if (!text_.skip_lines()) text_.refuse_here(element + " " + std::to_string(row) + " of " + std::to_string(count));
  }
  void end_row() {
    if (!text_.at_line_end()) text_.refuse_here("the end of the line");
  }
  double scalar(PlyScalar) {
    remember();
    return text_.number("a number");
  }
  std::size_t list_count(PlyScalar) {
    remember();
    const std::int64_t n = text_.integer("the length of a list");
    if (n < 0 || static_cast<std::uint64_t>(n) > text_.bytes_left() / 2 + 1)
      text_.refuse(at_, "the length of a list that fits into the file");
    return static_cast<std::size_t>(n);
  }
  std::int64_t index(PlyScalar) {
    remember();
    return text_.integer("the index of a vertex");
  }
  void skip(const PlyProperty& p) {
    std::size_t n = p.is_list ? list_count(p.count_type) : 1;
    for (; n != 0; --n)
      if (text_.word().empty()) text_.refuse_here("a value of " + in_quotes(p.name));
  }
  void skip_rows(const PlyElement&) {}
  [[noreturn]] void refuse_coordinate(std::uint64_t, double) { text_.refuse(at_, "a finite coordinate"); }
  [[noreturn]] void refuse_index(const std::string&, std::uint64_t, std::int64_t, const std::string& expected) {
    text_.refuse(at_, expected);
  }
  [[noreturn]] void refuse_row(const std::string&, std::uint64_t, const std::string& found, const std::string& expected) {
    text_.refuse(text_.position(), found, expected);
  }
  std::string rest() { return text_.skip_lines() ? "line " + std::to_string(text_.line()) + ": what follows" : std::string(); }
  void reserve_faces(const PlyElement&, int, ModelBuilder&) {}
  static constexpr bool is_ascii = true;

 private:
  void remember() {
    text_.skip_blanks();
    at_ = text_.position();
  }

  TextScanner text_;
  const char* at_ = nullptr;
};

/// The body as bytes.
class BinaryRows {
 public:
  BinaryRows(const Source& source, std::size_t body, ByteOrder order) : source_(source), bytes_(source, body, order) {}

  void begin_row(const std::string& element, std::uint64_t row, std::uint64_t count) {
    element_ = &element;
    row_ = row;
    count_ = count;
  }
  void end_row() {}
  double scalar(PlyScalar type) {
    need(size_of(type));
    switch (type) {
      case PlyScalar::int8:
        return bytes_.get<std::int8_t>();
      case PlyScalar::uint8:
        return bytes_.get<std::uint8_t>();
      case PlyScalar::int16:
        return bytes_.get<std::int16_t>();
      case PlyScalar::uint16:
        return bytes_.get<std::uint16_t>();
      case PlyScalar::int32:
        return bytes_.get<std::int32_t>();
      case PlyScalar::uint32:
        return bytes_.get<std::uint32_t>();
      case PlyScalar::float32:
        return bytes_.get<float>();
      case PlyScalar::float64:
        break;
    }
    return bytes_.get<double>();
  }
  std::size_t list_count(PlyScalar type) {
    const double n = scalar(type);
    if (n < 0) refuse_row(*element_, row_, "a list of length " + std::to_string(static_cast<std::int64_t>(n)), "0 or more");
    return static_cast<std::size_t>(n);
  }
  std::int64_t index(PlyScalar type) {
    if (type == PlyScalar::int32) {
      need(4);
      return bytes_.get<std::int32_t>();
    }
    const double i = scalar(type);
    if (!(std::abs(i) < 0x1p53) || i != std::floor(i)) refuse_row(*element_, row_, "an index that is not whole", "a whole one");
    return static_cast<std::int64_t>(i);
  }
  void skip(const PlyProperty& p) {
    const std::size_t n = p.is_list ? list_count(p.count_type) : 1;
    const std::size_t size = size_of(p.type);
    if (n > bytes_.left() / size) refuse_end();
    bytes_.skip(n * size);
  }
  /// All rows of an element without lists at once: the header has been checked against the size, but not with lists before.
  void skip_rows(const PlyElement& e) {
    const std::size_t size = e.least_size(false);
    if (size != 0 && e.count > bytes_.left() / size) {
      begin_row(e.name, bytes_.left() / size, e.count);
      refuse_end();
    }
    bytes_.skip(static_cast<std::size_t>(e.count) * size);
  }
  [[noreturn]] void refuse_coordinate(std::uint64_t vertex, double found) { bytes_.refuse_vertex(vertex, found); }
  [[noreturn]] void refuse_index(const std::string& element, std::uint64_t row, std::int64_t found,
                                 const std::string& expected) {
    refuse_row(element, row, "index " + std::to_string(found), expected);
  }
  [[noreturn]] void refuse_row(const std::string& element, std::uint64_t row, const std::string& found,
                               const std::string& expected) {
    source_.refuse(element + " " + std::to_string(row), "found " + found + ", expected " + expected);
  }
  std::string rest() { return bytes_.left() == 0 ? std::string() : "the last " + std::to_string(bytes_.left()) + " bytes"; }
  static constexpr bool is_ascii = false;
  /// What the faces of an element will take, if the bytes that are left can be so many of at least three corners.
  void reserve_faces(const PlyElement& e, int indices, ModelBuilder& model) const {
    const std::size_t index = size_of(e.properties[static_cast<std::size_t>(indices)].type);
    if (e.count <= bytes_.left() / (e.least_size(false) + 3 * index)) model.reserve_faces(e.count, 3 * e.count);
  }

 private:
  void need(std::size_t n) {
    if (bytes_.left() < n) refuse_end();
  }
  [[noreturn]] void refuse_end() {
    bytes_.refuse(source_.size(), "the end of the file",
                  *element_ + " " + std::to_string(row_) + " of " + std::to_string(count_));
  }

  const Source& source_;
  ByteScanner bytes_;
  const std::string* element_ = nullptr;
  std::uint64_t row_ = 0, count_ = 0;
};

/// Which properties of an element are a colour.
struct ColourProperties {
  std::array<int, 4> index = {-1, -1, -1, -1};

  explicit ColourProperties(const PlyElement& e) {
    constexpr std::array<std::array<const char*, 2>, 4> names = {
        {{"red", "diffuse_red"}, {"green", "diffuse_green"}, {"blue", "diffuse_blue"}, {"alpha", "diffuse_alpha"}}};
    for (std::size_t c = 0; c < 4; ++c)
      for (const char* name : names[c])
        if (index[c] < 0) index[c] = e.find(name, false);
  }
  bool is_complete() const { return index[0] >= 0 && index[1] >= 0 && index[2] >= 0; }
  int channel(int property) const {
    for (int c = 0; c < 4; ++c)
      if (index[static_cast<std::size_t>(c)] == property) return c;
    return -1;
  }
};

/// The largest value of a channel.
double whole_of(PlyScalar type) {
  return is_float(type) ? 1 : size_of(type) == 1 ? 255 : size_of(type) == 2 ? 65535 : 4294967295.0;
}

std::uint8_t channel_byte(PlyScalar type, double x) { return colour_byte(x / whole_of(type)); }

template <class Rows>
class PlyReader {
 public:
  PlyReader(const Source& source, const PlyHeader& header, Rows rows, const char* format)
      : source_(source), header_(header), rows_(std::move(rows)), model_(source, format) {}

  Model read() {
    find_vertices();
    for (const PlyElement& e : header_.elements) {
      if (e.properties.empty()) continue;
      if (e.name == "vertex")
        read_vertices(e);
      else if (e.name == "face" || e.name == "faces")
        read_faces(e);
      else if (e.name == "tristrips")
        read_strips(e);
      else if (e.name == "edge" && e.find("vertex1", false) >= 0 && e.find("vertex2", false) >= 0)
        read_edges(e);
      else
        skip_element(e);
    }
    const std::string rest = rows_.rest();
    if (!rest.empty()) model_.note(rest + " belong to no element");
    return model_.finish();
  }

 private:
  void find_vertices() {
    bool found = false;
    for (const PlyElement& e : header_.elements) {
      if (e.name != "vertex") continue;
      if (found) source_.refuse("", "found two elements \"vertex\", expected one");
      found = true;
      vertices_ = e.count;
      for (const char* axis : {"x", "y", "z"})
        if (e.find(axis, false) < 0)
          source_.refuse("", std::string("found an element \"vertex\" without property \"") + axis + "\", expected x, y and z");
    }
    if (!found) source_.refuse("", "found no element \"vertex\", expected one");
    if (vertices_ > ModelBuilder::most) model_.too_many("points");
  }

  void read_vertices(const PlyElement& e) {
    const std::array<int, 3> xyz = {e.find("x", false), e.find("y", false), e.find("z", false)};
    const ColourProperties colours(e);
    const std::size_t channels = !colours.is_complete() ? 0 : colours.index[3] >= 0 ? 4 : 3;
    std::array<double, 4> colour = {};
    model_.points().reserve(vertices_);  // the header's counts fit into the file
    for (std::uint64_t v = 0; v < vertices_; ++v) {
      rows_.begin_row(e.name, v, vertices_);
      std::array<double, 3> c = {};
      for (int i = 0; i < static_cast<int>(e.properties.size()); ++i) {
        const PlyProperty& p = e.properties[static_cast<std::size_t>(i)];
        const auto axis = std::find(xyz.begin(), xyz.end(), i);
        if (axis == xyz.end()) {
          const int channel = channels == 0 ? -1 : colours.channel(i);
          if (channel < 0)
            rows_.skip(p);
          else
            colour[static_cast<std::size_t>(channel)] = corner_channel(p.type);
          continue;
        }
        const double x = rows_.scalar(p.type);
        if (!std::isfinite(x)) rows_.refuse_coordinate(v, x);
        c[static_cast<std::size_t>(axis - xyz.begin())] = x;
      }
      rows_.end_row();
      model_.add_point(c[0], c[1], c[2]);
      if (channels != 0) model_.corner_colours().set(v, colour.data(), channels);
    }
  }

  /// The next scalar: of a whole type in bytes, else as it is.
  double corner_channel(PlyScalar type) {
    const double x = rows_.scalar(type);
    if (is_float(type)) return x;
    model_.corner_colours().are_bytes();
    return size_of(type) == 1 ? x : x / (whole_of(type) / 255);
  }

  std::uint32_t vertex(const PlyElement& e, std::uint64_t row, std::int64_t i) {
    if (i < 0 || static_cast<std::uint64_t>(i) >= vertices_)
      rows_.refuse_index(
          e.name, row, i,
          vertices_ == 0 ? std::string("no element without vertices") : "an index from 0 to " + std::to_string(vertices_ - 1));
    return static_cast<std::uint32_t>(i);
  }

  int index_list(const PlyElement& e) const {
    const int indices = e.find("vertex_indices", true);
    return indices >= 0 ? indices : e.find("vertex_index", true);
  }

  void read_faces(const PlyElement& e) {
    const int indices = index_list(e);
    if (indices < 0 && e.count != 0)
      source_.refuse("", "found an element \"face\" without list \"vertex_indices\" or \"vertex_index\", expected one");
    const ColourProperties colours(e);
    if (indices >= 0) rows_.reserve_faces(e, indices, model_);
    for (std::uint64_t f = 0; f < e.count; ++f) {
      rows_.begin_row(e.name, f, e.count);
      Colour colour = {0, 0, 0, 255};
      for (int i = 0; i < static_cast<int>(e.properties.size()); ++i) {
        const PlyProperty& p = e.properties[static_cast<std::size_t>(i)];
        if (i == indices) {
          const std::size_t n = rows_.list_count(p.count_type);
          if (n < 3)
            rows_.refuse_row(e.name, f, "a face of " + std::to_string(n) + (n == 1 ? " corner" : " corners"), "3 or more");
          for (std::size_t k = 0; k < n; ++k) model_.add_corner(vertex(e, f, rows_.index(p.type)));
        } else if (const int c = colours.channel(i); c >= 0) {
          colour[static_cast<std::size_t>(c)] = channel_byte(p.type, rows_.scalar(p.type));
        } else {
          rows_.skip(p);
        }
      }
      rows_.end_row();
      if (colours.is_complete()) model_.set_colour(colour);
      model_.end_face();
    }
  }

  /// Triangles that share two vertices with the one before; -1 begins anew. A triangle that repeats a vertex only turns the
  /// strip.
  void read_strips(const PlyElement& e) {
    const int indices = index_list(e);
    for (std::uint64_t row = 0; row < e.count; ++row) {
      rows_.begin_row(e.name, row, e.count);
      for (int i = 0; i < static_cast<int>(e.properties.size()); ++i) {
        const PlyProperty& p = e.properties[static_cast<std::size_t>(i)];
        if (i != indices) {
          rows_.skip(p);
          continue;
        }
        std::uint32_t a = 0, b = 0;
        std::size_t in_strip = 0;
        for (std::size_t n = rows_.list_count(p.count_type); n != 0; --n) {
          const std::int64_t index = rows_.index(p.type);
          if (index == -1) {
            in_strip = 0;
            continue;
          }
          const std::uint32_t c = vertex(e, row, index);
          if (in_strip >= 2 && a != b && b != c && c != a) {
            if (in_strip % 2 == 0)
              model_.add_triangle(a, b, c);
            else
              model_.add_triangle(b, a, c);
          }
          a = b;
          b = c;
          ++in_strip;
        }
      }
      rows_.end_row();
    }
  }

  void read_edges(const PlyElement& e) {
    const int first = e.find("vertex1", false), second = e.find("vertex2", false);
    for (std::uint64_t row = 0; row < e.count; ++row) {
      rows_.begin_row(e.name, row, e.count);
      std::uint32_t a = 0, b = 0;
      for (int i = 0; i < static_cast<int>(e.properties.size()); ++i) {
        const PlyProperty& p = e.properties[static_cast<std::size_t>(i)];
        if (i == first)
          a = vertex(e, row, rows_.index(p.type));
        else if (i == second)
          b = vertex(e, row, rows_.index(p.type));
        else
          rows_.skip(p);
      }
      rows_.end_row();
      model_.add_segment(a, b);
    }
  }

  void skip_element(const PlyElement& e) {
    if (!Rows::is_ascii && !e.has_lists()) {
      rows_.skip_rows(e);
      return;
    }
    for (std::uint64_t row = 0; row < e.count; ++row) {
      rows_.begin_row(e.name, row, e.count);
      for (const PlyProperty& p : e.properties) rows_.skip(p);
      rows_.end_row();
    }
  }

  const Source& source_;
  const PlyHeader& header_;
  Rows rows_;
  ModelBuilder model_;
  std::uint64_t vertices_ = 0;
};

}  // namespace

bool looks_like_ply(const Source& source) {
  const std::string_view b = source.bytes;
  return b.substr(0, 3) == "ply" && b.size() > 3 && (b[3] == '\n' || b[3] == '\r' || b[3] == ' ');
}

Model read_ply(const Source& source) {
  const PlyHeader header = read_ply_header(source);
  switch (header.format) {
    case PlyFormat::ascii:
      return PlyReader<AsciiRows>(source, header, AsciiRows(source, header.body), "PLY ascii").read();
    case PlyFormat::little_endian:
      return PlyReader<BinaryRows>(source, header, BinaryRows(source, header.body, ByteOrder::little),
                                   "PLY binary little-endian")
          .read();
    case PlyFormat::big_endian:
      break;
  }
  return PlyReader<BinaryRows>(source, header, BinaryRows(source, header.body, ByteOrder::big), "PLY binary big-endian").read();
}

}  // namespace hsr::internal::read
