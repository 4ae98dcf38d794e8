#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hsr/model.h"

namespace hsr::internal::read {

/// The colours of a binary STL file, which are in the two bytes behind each triangle: five bits a channel, by one of two customs.
///
/// * VisCAM and SolidView: blue, green, red from the lowest bit on; the highest bit says that the triangle has a colour.
/// * Magics, in files whose header has "COLOR=" and four bytes (red, green, blue, opacity), the colour of the part: red, green,
///   blue from the lowest bit on; the highest bit says that the triangle has the colour of the part. Where the two bytes are 0
///   throughout nobody has set them, and all triangles have that colour.
///
/// Five bits become eight by 255/31, rounded.
class StlColours {
 public:
  /// @param header 80 bytes @param has_attributes whether any triangle has other bytes than 0
  StlColours(std::string_view header, bool has_attributes);

  std::optional<Colour> of(std::uint16_t attribute) const;

 private:
  std::optional<Colour> part_;
  bool has_attributes_;
};

/// The colour of 15 bits by the custom of VisCAM, whatever the highest one says.
Colour viscam_colour(std::uint16_t bits);

}  // namespace hsr::internal::read
