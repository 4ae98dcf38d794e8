#include "hsr/io/read/json_depth.h"

namespace hsr::internal::read {

void check_json_depth(const Source& source, std::string_view text, std::size_t first_byte) {
  constexpr int deepest = 100;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > deepest)
        source.refuse("byte " + std::to_string(first_byte + i),
                      "found more than 100 brackets inside each other, expected fewer");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

}  // namespace hsr::internal::read
