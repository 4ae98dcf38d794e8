#include "hsr/io/read/stl_colour.h"

namespace hsr::internal::read {

namespace {

/// Five bits from bit `lowest` on, as a byte.
std::uint8_t channel(std::uint16_t bits, int lowest) {
  return static_cast<std::uint8_t>(((bits >> lowest & 31) * 255 * 2 + 31) / 62);
}

}  // namespace

Colour viscam_colour(std::uint16_t bits) { return {channel(bits, 10), channel(bits, 5), channel(bits, 0), 255}; }

StlColours::StlColours(std::string_view header, bool has_attributes) : has_attributes_(has_attributes) {
  constexpr std::string_view key = "COLOR=";
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos || header.size() - at < key.size() + 4) return;
  Colour colour;
  for (std::size_t c = 0; c < 4; ++c) colour[c] = static_cast<std::uint8_t>(header[at + key.size() + c]);
  part_ = colour;
}

std::optional<Colour> StlColours::of(std::uint16_t attribute) const {
  const bool highest = (attribute & 0x8000U) != 0;
  if (!part_) return highest ? std::optional<Colour>(viscam_colour(attribute)) : std::nullopt;
  if (highest || !has_attributes_) return part_;
  return Colour{channel(attribute, 0), channel(attribute, 5), channel(attribute, 10), (*part_)[3]};
}

}  // namespace hsr::internal::read
