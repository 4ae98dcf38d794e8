#include "hsr/io/write/json_text.h"

#include <charconv>

#include "hsr/utf8.h"

namespace hsr::internal {

void append_integer(std::string& out, std::uint64_t x) {
  char text[24];
  const auto [end, error] = std::to_chars(text, text + sizeof text, x);
  out.append(text, end);
}

void append_number(std::string& out, double x, Numbers numbers) {
  if (numbers == Numbers::exact) {
    out += '"';
    out += Rational(x).to_string();
    out += '"';
    return;
  }
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, x + 0.0);  // never -0
  out.append(text, end);
}

void append_rational(std::string& out, const Rational& x, Numbers numbers) {
  if (numbers == Numbers::exact)
    out += '"' + x.to_string() + '"';
  else
    append_number(out, x.to_double(), numbers);
}

void append_point(std::string& out, const Point3& p, Numbers numbers) {
  out += '[';
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) out += ", ";
    append_number(out, p[axis], numbers);
  }
  out += ']';
}

void append_string(std::string& out, std::string_view text) {
  static constexpr char digits[] = "0123456789abcdef";
  out += '"';
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = utf8_character(text, i);
    if (c.bytes == 0) {
      out += replacement_character;
      ++i;
      continue;
    }
    if (c.code == '"' || c.code == '\\') {
      out += '\\';
      out += static_cast<char>(c.code);
    } else if (c.code < 0x20) {
      out += "\\u00";
      out += digits[c.code >> 4];
      out += digits[c.code & 15];
    } else {
      out.append(text, i, c.bytes);
    }
    i += c.bytes;
  }
  out += '"';
}

}  // namespace hsr::internal
