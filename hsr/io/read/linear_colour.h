#pragma once

#include <array>
#include <cstdint>

namespace hsr::internal::read {

/// Red, green and blue as amounts of light, 0 to 1, and opacity: what glTF computes with.
using LinearColour = std::array<double, 4>;

/// The byte of sRGB that is nearest to an amount of light; what is beyond 0 or 1 is clamped, NaN is 0.
/// Source: IEC 61966-2-1.
std::uint8_t srgb_byte(double linear);

/// The amount of light of a byte of sRGB.
double linear_of_srgb(std::uint8_t byte);

}  // namespace hsr::internal::read
