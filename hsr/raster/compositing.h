#pragma once

#include <array>
#include <cmath>

#include "hsr/model.h"

namespace hsr::internal {

/// Red, green and blue while colours are laid over one another: 0 ... 255.
using Light = std::array<float, 3>;
constexpr Light white_light = {255, 255, 255};

/// Lays a colour over what is there. @param opacity 0 ... 1; with that of the colour itself
inline void lay_over(Light& light, const Colour& c, float opacity) {
  for (std::size_t k = 0; k < 3; ++k) light[k] += opacity * (static_cast<float>(c[k]) - light[k]);
}
/// Of a colour whose opacity is made less by a factor.
inline float opacity_of(const Colour& c, double factor) { return static_cast<float>(factor * c[3] / 255); }

inline Colour rounded(const Light& light) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x)); };
  return {byte(light[0]), byte(light[1]), byte(light[2]), 255};
}

}  // namespace hsr::internal
