#include "hsr/io/read/corner_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hsr::internal::read {

namespace {

constexpr float no_colour = std::numeric_limits<float>::quiet_NaN();
constexpr float opaque = std::numeric_limits<float>::infinity();

}  // namespace

void CornerColours::set(std::size_t point, const double* channels, std::size_t n) {
  std::array<float, 4> colour = {no_colour, no_colour, no_colour, opaque};
  for (std::size_t i = 0; i < std::min<std::size_t>(n, 4); ++i) {
    largest_ = std::max(largest_, channels[i]);
    colour[i] = static_cast<float>(std::clamp(channels[i], 0.0, 255.0));
  }
  channels_.resize(point, {no_colour, no_colour, no_colour, opaque});
  channels_.push_back(colour);
}

std::optional<Colour> CornerColours::mean(const std::uint32_t* first, const std::uint32_t* last) const {
  if (first == last) return {};
  const double to_byte = largest_ > 1 ? 1 : 255;
  std::array<double, 4> sum = {};
  for (const std::uint32_t* corner = first; corner != last; ++corner) {
    if (*corner >= channels_.size() || std::isnan(channels_[*corner][0])) return {};
    for (std::size_t c = 0; c < 4; ++c) {
      const float channel = channels_[*corner][c];
      sum[c] += channel == opaque ? 255 : channel * to_byte;  // exact for bytes
    }
  }
  Colour colour;
  const auto corners = static_cast<double>(last - first);
  for (std::size_t c = 0; c < 4; ++c)
    colour[c] = static_cast<std::uint8_t>(std::lround(std::clamp(sum[c] / corners, 0.0, 255.0)));
  return colour;
}

}  // namespace hsr::internal::read
