#include "hsr/io/write/json_text.h"

#include <charconv>

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
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += digits[byte >> 4];
      out += digits[byte & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

}  // namespace hsr::internal
