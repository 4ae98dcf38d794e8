#include "hsr/io/write/svg_text.h"

#include <charconv>
#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/utf8.h"

namespace hsr::internal {

void append_coordinate(std::string& out, std::int64_t thousandths) {
  if (thousandths < 0) out += '-';
  const std::uint64_t magnitude =
      thousandths < 0 ? 0 - static_cast<std::uint64_t>(thousandths) : static_cast<std::uint64_t>(thousandths);
  append_integer(out, magnitude / 1000);
  auto rest = static_cast<unsigned>(magnitude % 1000);
  if (rest == 0) return;
  out += '.';
  for (unsigned place = 100; rest != 0; place /= 10) {
    out += static_cast<char>('0' + rest / place);
    rest %= place;
  }
}

void append_length(std::string& out, double mm) {
  char text[400];  // the largest double has 309 digits, the least one 324 places before its first
  const auto [end, error] = std::to_chars(text, text + sizeof text, mm, std::chars_format::fixed);
  out.append(text, end);
}

void append_rounded_length(std::string& out, double mm) { append_length(out, std::round(mm * 1e4) / 1e4); }

void append_text(std::string& out, const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = utf8_character(text, i);
    const bool is_text =
        c.bytes > 0 && c.code != 0xFFFE && c.code != 0xFFFF && (c.code >= 0x20 || c.code == '\t' || c.code == '\n');
    if (!is_text) {
      out += replacement_character;
      ++i;
      continue;
    }
    if (c.code == '<')
      out += "&lt;";
    else if (c.code == '>')
      out += "&gt;";
    else if (c.code == '&')
      out += "&amp;";
    else if (c.code == '"')
      out += "&quot;";
    else
      out.append(text, i, c.bytes);
    i += c.bytes;
  }
}

void append_points(std::string& out, std::span<const PaperPoint> points) {
  out += 'M';
  bool first = true;
  for (const PaperPoint& point : points) {
    if (!first) out += ' ';
    first = false;
    append_coordinate(out, point.x);
    out += ' ';
    append_coordinate(out, point.y);
  }
}

void append_colour(std::string& out, const Colour& colour) {
  static constexpr const char* digits = "0123456789abcdef";
  out += '#';
  for (std::size_t k = 0; k < 3; ++k) {
    out += digits[colour[k] / 16];
    out += digits[colour[k] % 16];
  }
}

void append_svg_start(std::string& out, double width, double height, const SvgOptions& options) {
  out += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" ";
  out += "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
  append_length(out, width);
  out += "mm\" height=\"";
  append_length(out, height);
  out += "mm\" viewBox=\"0 0 ";
  append_length(out, width);
  out += ' ';
  append_length(out, height);
  out += "\">\n";
  if (!options.title.empty()) {
    out += "<title>";
    append_text(out, options.title);
    out += "</title>\n";
  }
  if (!options.description.empty()) {
    out += "<desc>";
    append_text(out, options.description);
    out += "</desc>\n";
  }
}

}  // namespace hsr::internal
