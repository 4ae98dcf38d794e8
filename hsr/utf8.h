#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hsr::internal {

/// What stands in a text for bytes that are no character of it.
inline constexpr const char* replacement_character = "\xEF\xBF\xBD";

/// One character of UTF-8, and how many bytes it takes; none: the bytes are malformed.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

/// The text in one line of printable ASCII, at most 200 characters; "?" stands for others.
std::string printable(std::string_view text);

/// The character that begins at text[i]. @pre i < text.size()
Utf8Character utf8_character(std::string_view text, std::size_t i);

}  // namespace hsr::internal
