#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "hsr/io/read/byte_scanner.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/merged_points.h"
#include "hsr/io/read/model_builder.h"
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

Model read_binary(const Source& source) {
  const std::size_t size = source.bytes.size();
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
  MergedPoints merged(model.points());
  ByteScanner bytes(source, header_size, ByteOrder::little);
  for (std::uint64_t t = 0; t < n; ++t) {
    bytes.skip(12);  // the normal
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

class AsciiStlReader {
 public:
  explicit AsciiStlReader(const Source& source) : text_(source, {}), model_(source, "STL ascii"), merged_(model_.points()) {}

  Model read() {
    int solids = 0;
    while (text_.skip_lines()) {
      expect("solid");
      const std::string_view name = text_.rest_of_line();
      ++solids;
      if (!name.empty() || solids > 1)
        model_.start_object(name.empty() ? "solid " + std::to_string(solids) : std::string(name));
      while (!at_word("endsolid")) read_facet();
      text_.next_line();
    }
    return model_.finish();
  }

 private:
  /// Is this the next word? Does not move then, but for the lines before it.
  bool at_word(const char* lower) {
    if (!text_.skip_lines()) text_.refuse_here("facet or endsolid");
    const char* const at = text_.position();
    const bool same = same_word(text_.word(), lower);
    text_.move_to(at);
    return same;
  }
  void expect(const char* lower) {
    if (!text_.skip_lines()) text_.refuse_here(lower);
    const char* const at = text_.position();
    if (!same_word(text_.word(), lower)) text_.refuse(at, lower);
  }
  void read_facet() {
    if (!at_word("facet")) text_.refuse_here("facet or endsolid");
    text_.next_line();  // the normal may be anything, NaN too: nobody uses it
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = text_.number("a coordinate");
      const double y = text_.number("a coordinate");
      const double z = text_.number("a coordinate");
      model_.add_corner(merged_.index({x, y, z}));
    }
    expect("endloop");
    expect("endfacet");
    model_.end_face();
  }

  TextScanner text_;
  ModelBuilder model_;
  MergedPoints merged_;
};

}  // namespace

bool looks_like_binary_stl(const Source& source) {
  return source.bytes.size() > header_size && source.bytes.size() == header_size + triangle_size * counted_triangles(source);
}

bool looks_like_ascii_stl(const Source& source) {
  TextScanner text(source, {});
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
