#include "hsr/io/read/ply_header.h"

#include <optional>

#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

std::optional<PlyScalar> scalar(std::string_view word) {
  if (word == "char" || word == "int8") return PlyScalar::int8;
  if (word == "uchar" || word == "uint8") return PlyScalar::uint8;
  if (word == "short" || word == "int16") return PlyScalar::int16;
  if (word == "ushort" || word == "uint16") return PlyScalar::uint16;
  if (word == "int" || word == "int32") return PlyScalar::int32;
  if (word == "uint" || word == "uint32") return PlyScalar::uint32;
  if (word == "float" || word == "float32") return PlyScalar::float32;
  if (word == "double" || word == "float64") return PlyScalar::float64;
  return {};
}

PlyScalar read_scalar(TextScanner& text, const char* expected) {
  text.skip_blanks();
  const char* const at = text.position();
  const std::optional<PlyScalar> type = scalar(text.word());
  if (!type) text.refuse(at, expected);
  return *type;
}

PlyFormat read_format(TextScanner& text) {
  text.skip_blanks();
  const char* const at = text.position();
  const std::string_view word = text.word();
  if (word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
    text.refuse(at, "ascii, binary_little_endian or binary_big_endian");
  text.skip_blanks();
  const char* const version_at = text.position();
  if (text.word() != "1.0") text.refuse(version_at, "version 1.0");
  return word == "ascii" ? PlyFormat::ascii : word == "binary_big_endian" ? PlyFormat::big_endian : PlyFormat::little_endian;
}

PlyProperty read_property(TextScanner& text) {
  PlyProperty property;
  text.skip_blanks();
  const char* const at = text.position();
  if (text.word() == "list") {
    property.is_list = true;
    property.count_type = read_scalar(text, "the type of the list's count");
    if (is_float(property.count_type)) text.refuse(at, "a list whose count is a whole number");
  } else {
    text.move_to(at);
  }
  property.type = read_scalar(text, "a type of PLY (char, uchar, short, ushort, int, uint, float, double) or list");
  property.name = text.rest_of_line();
  if (property.name.empty()) text.refuse_here("the name of a property");
  return property;
}

PlyElement read_element(TextScanner& text) {
  PlyElement element;
  element.name = text.word();
  if (element.name.empty()) text.refuse_here("the name of an element");
  text.skip_blanks();
  const char* const at = text.position();
  const std::int64_t n = text.integer("how many there are of an element");
  if (n < 0) text.refuse(at, "how many there are of an element");
  element.count = static_cast<std::uint64_t>(n);
  return element;
}

}  // namespace

std::size_t size_of(PlyScalar type) {
  switch (type) {
    case PlyScalar::int8:
    case PlyScalar::uint8:
      return 1;
    case PlyScalar::int16:
    case PlyScalar::uint16:
      return 2;
    case PlyScalar::int32:
    case PlyScalar::uint32:
    case PlyScalar::float32:
      return 4;
    case PlyScalar::float64:
      break;
  }
  return 8;
}

bool is_float(PlyScalar type) { return type == PlyScalar::float32 || type == PlyScalar::float64; }

int PlyElement::find(std::string_view property, bool list) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && properties[i].is_list == list) return static_cast<int>(i);
  return -1;
}

bool PlyElement::has_lists() const {
  for (const PlyProperty& p : properties)
    if (p.is_list) return true;
  return false;
}

std::size_t PlyElement::least_size(bool ascii) const {
  if (ascii) return 2 * properties.size();  // a digit and what separates it
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += size_of(p.is_list ? p.count_type : p.type);
  return size;
}

PlyHeader read_ply_header(const Source& source) {
  TextScanner text(source, {});
  PlyHeader header;
  bool has_format = false;
  std::vector<const char*> counted_at;
  if (text.word() != "ply") text.refuse(source.bytes.data(), "ply");
  text.next_line();
  // A header of CR LF ends with both of them; one of CR alone must not swallow a first byte that happens to be LF.
  for (;; text.next_line()) {
    if (!text.skip_lines()) text.refuse_here("end_header");
    const char* const at = text.position();
    const std::string_view word = text.word();
    if (word == "end_header") break;
    if (word == "comment" || word == "obj_info") continue;
    if (word == "format") {
      header.format = read_format(text);
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(text));
      counted_at.push_back(at);
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(text));
    } else {
      text.refuse(at, "format, element, property, comment or end_header");
    }
    if (!text.at_line_end()) text.refuse_here("the end of the line");
  }
  if (!has_format) text.refuse_here("a line that begins with format, before end_header");
  const std::size_t first_break = source.bytes.find_first_of("\r\n");
  const bool lone_cr = source.bytes[first_break] == '\r' && source.bytes[first_break + 1] != '\n';
  const char* const line_end =
      source.bytes.data() + std::min(source.bytes.find_first_of("\r\n", text.offset()), source.bytes.size());
  text.move_to(line_end);
  if (lone_cr && !text.at_end())
    text.move_to(line_end + 1);
  else
    text.next_line();
  header.body = text.offset();

  const std::size_t left = source.size() - header.body;
  std::size_t used = 0;
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    const PlyElement& e = header.elements[i];
    const std::size_t size = e.least_size(header.format == PlyFormat::ascii);
    // The last row of a text may lack its line end.
    if (size == 0) continue;
    if (e.count > (left - used + 1) / size)
      text.refuse(counted_at[i], std::to_string(e.count) + " of element " + in_quotes(e.name),
                  "no more than fit into the " + std::to_string(left) + " bytes behind the header");
    used = std::min(left, used + static_cast<std::size_t>(e.count) * size);
  }
  return header;
}

}  // namespace hsr::internal::read
