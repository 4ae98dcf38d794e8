#include "hsr/io/read/linear_colour.h"

#include <cmath>

namespace hsr::internal::read {

namespace {

std::array<double, 256> make_table() {
  std::array<double, 256> table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const long double s = static_cast<long double>(i) / 255;
    table[i] = static_cast<double>(s <= 0.04045L ? s / 12.92L : std::pow((s + 0.055L) / 1.055L, 2.4L));
  }
  return table;
}

}  // namespace

std::uint8_t srgb_byte(double linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  const long double x = linear;
  const long double s = x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

double linear_of_srgb(std::uint8_t byte) {
  static const std::array<double, 256> table = make_table();
  return table[byte];
}

}  // namespace hsr::internal::read
