#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hsr/io/read/byte_scanner.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/material_library.h"
#include "hsr/io/read/merged_points.h"
#include "hsr/io/read/model_builder.h"
#include "hsr/io/read/stl_colour.h"
#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

bool same_word(std::string_view a, std::string_view lower) {
  return a.size() == lower.size() &&
         std::equal(a.begin(), a.end(), lower.begin(), [](char c, char l) { return (c >= 'A' && c <= 'Z' ? c + 32 : c) == l; });
}

std::uint64_t counted_triangles(const Source& source) {
  return ByteScanner(source, 80, ByteOrder::little).get<std::uint32_t>();
}

/// Whether the two bytes behind any triangle are other than 0.
bool has_attributes(const Source& source, std::uint64_t triangles) {
  ByteScanner bytes(source, header_size, ByteOrder::little);
  for (std::uint64_t t = 0; t < triangles; ++t) {
    bytes.skip(triangle_size - 2);
    if (bytes.get<std::uint16_t>() != 0) return true;
  }
  return false;
}

Model read_binary(const Source& source) {
  const std::size_t size = source.size();
  if (size < header_size)
    source.refuse("", "found " + std::to_string(size) + " bytes, expected the 84 of a binary STL header, or \"solid\"");
  const std::uint64_t n = counted_triangles(source);
  const std::uint64_t expected = header_size + triangle_size * n;
  if (size < expected)
    source.refuse("byte 80", "found a file of " + std::to_string(size) + " bytes, expected " + std::to_string(expected) +
                                 " for " + std::to_string(n) + " triangles");
  if (n == 0 && size > header_size)
    source.refuse("byte 80", "found 0 triangles in a file of " + std::to_string(size) + " bytes, expected their number");
  ModelBuilder model(source, "STL binary");
  if (size > expected) model.note("the last " + std::to_string(size - expected) + " bytes belong to no triangle");
  model.reserve_faces(n, 3 * n);
  MergedPoints merged(model.points());
  const StlColours colours(source.bytes.substr(0, 80), has_attributes(source, n));
  ByteScanner bytes(source, header_size, ByteOrder::little);
  for (std::uint64_t t = 0; t < n; ++t) {
    bytes.skip(12);  // the normal
    model.set_colour(colours.of(bytes.peek<std::uint16_t>(bytes.next(triangle_size - 12) + 36)));
    for (int k = 0; k < 3; ++k) {
      Point3 p;
      for (double* const c : {&p.x, &p.y, &p.z}) {
        *c = bytes.get<float>();
        if (!std::isfinite(*c))
          source.refuse("face " + std::to_string(t),
                        std::string("found ") + (std::isnan(*c) ? "NaN" : "infinity") + ", expected a finite coordinate");
      }
      model.add_corner(merged.index(p));
    }
    model.end_face();
    bytes.skip(2);  // the attribute
  }
  return model.finish();
}

/// Reads what is plainly meant: `endsolid` may be missing at the end of the file and before the next `solid`, two words may be
/// written as one or one as two (`endloop endfacet`, `end loop`), in any case of letters, and `#` begins a comment.
///
/// A facet may have `color` and a number of 15 bits by the custom of VisCAM, or red, green and blue as fractions or of 255: in the
/// line of `facet` or of `endfacet`, or in one of its own between them.
class AsciiStlReader {
 public:
  explicit AsciiStlReader(const Source& source)
      : text_(source, {.comment = '#', .continuation = false}), model_(source, "STL ascii"), merged_(model_.points()) {}

  Model read() {
    model_.call_first_object("solid 1");
    int solids = 0;
    while (text_.skip_lines()) {
      expect("solid");
      const std::string_view name = text_.rest_of_line();
      ++solids;
      if (!name.empty() || solids > 1)
        model_.start_object(name.empty() ? "solid " + std::to_string(solids) : std::string(name));
      while (text_.skip_lines() && !at("solid")) {
        if (skip_words("end", "solid")) {
          text_.next_line();
          break;
        }
        read_facet();
      }
    }
    return model_.finish();
  }

 private:
  /// Does the next word begin so? A word may go on with the next one.
  bool at(std::string_view lower) {
    if (!text_.skip_lines()) return false;
    const char* const p = text_.position();
    return text_.bytes_left() >= lower.size() && same_word({p, lower.size()}, lower);
  }
  bool skip_word(std::string_view lower) {
    if (!at(lower)) return false;
    text_.move_to(text_.position() + lower.size());
    return true;
  }
  /// The same for a word that may be written as two.
  bool skip_words(const char* first, const char* second) {
    if (!at(first)) return false;
    const char* const start = text_.position();
    if (skip_word(first) && skip_word(second)) return true;
    text_.move_to(start);
    return false;
  }
  void expect(const char* lower) {
    if (!skip_word(lower)) text_.refuse_here(lower);
  }
  void expect(const char* first, const char* second) {
    if (!skip_words(first, second)) text_.refuse_here(std::string(first) + second);
  }

  /// The statement of a colour, if it comes next.
  bool read_colour(std::optional<Colour>& colour) {
    if (!skip_word("color") && !skip_word("colour")) return false;
    text_.skip_blanks();
    const char* const start = text_.position();
    std::array<double, 3> c = {};
    std::size_t n = 0;
    while (n < c.size()) {
      const std::optional<double> x = text_.number_if_any();
      if (!x) break;
      c[n++] = *x;
    }
    if (n == 1 && c[0] >= 0 && c[0] < 65536 && c[0] == std::floor(c[0])) {
      colour = viscam_colour(static_cast<std::uint16_t>(c[0]));
    } else if (n == 3) {
      const double whole = std::all_of(c.begin(), c.end(), [](double x) { return x <= 1; }) ? 1 : 255;
      colour = Colour{colour_byte(c[0] / whole), colour_byte(c[1] / whole), colour_byte(c[2] / whole), 255};
    } else {
      text_.refuse(start, "a colour: a number of 15 bits, or red, green and blue");
    }
    return true;
  }

  void read_facet() {
    if (!skip_word("facet")) text_.refuse_here("facet or endsolid");
    std::optional<Colour> colour;
    // The normal may be anything, NaN too: nobody uses it.
    while (!text_.at_line_end() && !at("outer"))
      if (!read_colour(colour)) text_.word();
    while (read_colour(colour)) continue;
    expect("outer", "loop");
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = text_.number("a coordinate");
      const double y = text_.number("a coordinate");
      const double z = text_.number("a coordinate");
      model_.add_corner(merged_.index({x, y, z}));
    }
    expect("end", "loop");
    while (read_colour(colour)) continue;
    expect("end", "facet");
    if (!text_.at_line_end()) read_colour(colour);
    model_.set_colour(colour);
    model_.end_face();
  }

  TextScanner text_;
  ModelBuilder model_;
  MergedPoints merged_;
};

}  // namespace

bool looks_like_binary_stl(const Source& source) {
  return source.size() > header_size && source.size() == header_size + triangle_size * counted_triangles(source);
}

bool looks_like_ascii_stl(const Source& source) {
  TextScanner text(source, {.comment = '#', .continuation = false});
  if (!text.skip_lines() || !same_word(text.word(), "solid")) return false;
  // A binary file may begin with "solid" too, but then what follows is not text.
  const std::string_view head = source.bytes.substr(0, 1024);
  return std::none_of(head.begin(), head.end(), [](char c) { return c >= 0 && c < '\t'; });
}

Model read_stl(const Source& source) {
  if (!looks_like_binary_stl(source) && looks_like_ascii_stl(source)) return AsciiStlReader(source).read();
  return read_binary(source);
}

}  // namespace hsr::internal::read
