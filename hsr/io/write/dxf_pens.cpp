#include "hsr/io/write/dxf_pens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "hsr/io/write/dxf_tables.h"

namespace hsr::internal {

namespace {

/// From 10 to 249 in 24 hues from red on, each in five values, pure and paler.
Colour hue_colour(int number) {
  static constexpr std::array<int, 5> values = {255, 189, 129, 104, 79};
  const int high = values[static_cast<std::size_t>(number % 10 / 2)], low = number % 2 == 0 ? 0 : high * 2 / 3;
  const int hue = number / 10 - 1;  // of 24
  // Red, yellow, green, cyan, blue and magenta are 4 apart.
  const auto channel = [&](int peak) {
    const int d = std::abs((hue - peak + 36) % 24 - 12);
    const int part = std::clamp(8 - d, 0, 4);
    return static_cast<std::uint8_t>(low + (high - low) * part / 4);
  };
  return {channel(0), channel(8), channel(16), 255};
}

Colour colour_numbered(int number) {
  static constexpr std::array<Colour, 10> first = {{{},
                                                    {255, 0, 0, 255},
                                                    {255, 255, 0, 255},
                                                    {0, 255, 0, 255},
                                                    {0, 255, 255, 255},
                                                    {0, 0, 255, 255},
                                                    {255, 0, 255, 255},
                                                    {0, 0, 0, 255},
                                                    {128, 128, 128, 255},
                                                    {192, 192, 192, 255}}};
  static constexpr std::array<std::uint8_t, 6> greys = {51, 80, 105, 130, 190, 255};
  if (number < 10) return first[static_cast<std::size_t>(number)];
  if (number < 250) return hue_colour(number);
  const std::uint8_t grey = greys[static_cast<std::size_t>(number - 250)];
  return {grey, grey, grey, 255};
}

}  // namespace

int dxf_colour(const Colour& colour) {
  int nearest = 7, least = 1 << 30;
  for (int number = 1; number <= 255; ++number) {
    const Colour c = colour_numbered(number);
    int distance = 0;
    for (std::size_t k = 0; k < 3; ++k) distance += (c[k] - colour[k]) * (c[k] - colour[k]);
    if (distance >= least) continue;
    least = distance;
    nearest = number;
  }
  return nearest;
}

int dxf_line_weight(double width) {
  static constexpr std::array<int, 24> weights = {0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                                  53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
  return *std::ranges::min_element(weights, {}, [&](int w) { return std::abs(w - 100 * width); });
}

DxfLineType dxf_line_type(const Layer& layer, double dash_unit) {
  DxfLineType type;
  for (const double length : layer.pen.dashes) type.dashes.push_back(std::round(length / dash_unit * 1e6) / 1e6);
  if (type.dashes == std::vector<double>{12, 3})
    type.name = "ACAD_ISO02W100";
  else if (!type.dashes.empty())
    type.name = dxf_layer_name(layer);
  return type;
}

}  // namespace hsr::internal
