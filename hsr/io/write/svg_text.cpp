#include "hsr/io/write/svg_text.h"

#include <charconv>

#include "hsr/io/write/json_text.h"

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
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, mm, std::chars_format::fixed);
  out.append(text, end);
}

/// Text as XML: what XML 1.0 cannot carry becomes U+FFFD, malformed UTF-8 too.
void append_text(std::string& out, const std::string& text) {
  static constexpr const char* replacement = "\xEF\xBF\xBD";
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80                ? 1
                               : c >= 0xC2 && c < 0xE0 ? 2
                               : c >= 0xE0 && c < 0xF0 ? 3
                               : c >= 0xF0 && c < 0xF5 ? 4
                                                       : 0;
    bool good = length > 0 && i + length <= text.size();
    std::uint32_t code = length == 1 ? c : c & (0xFFU >> (length + 1));
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = (next & 0xC0U) == 0x80U;
      code = code << 6 | (next & 0x3FU);
    }
    static constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    good = good && code >= least[length] && code <= 0x10FFFF && !(code >= 0xD800 && code < 0xE000) && code != 0xFFFE &&
           code != 0xFFFF && (code >= 0x20 || code == '\t' || code == '\n');
    if (!good) {
      out += replacement;
      ++i;
      continue;
    }
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out.append(text, i, length);
    i += length;
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

void append_svg_start(std::string& out, double width, double height, const SvgOptions& options, bool links) {
  out += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" ";
  if (links) out += "xmlns:xlink=\"http://www.w3.org/1999/xlink\" ";
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
