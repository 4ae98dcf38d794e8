#include "hsr/cli/output_summary.h"

#include <fmt/core.h>

#include <algorithm>

#include "geometry/error.h"

namespace hsr::cli {

std::string counted(std::uint64_t count, const std::string& one) {
  if (count == 0) return "no " + one + "s";
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string paper_size(double width, double height) { return fmt::format("{:.6g} x {:.6g} mm", width, height); }

std::string model_size(const Drawing& drawing, double unit) {
  const char* const name = unit == 1 ? " mm" : unit == 10 ? " cm" : unit == 1000 ? " m" : unit == 25.4 ? " in" : " units";
  if (drawing.points.empty()) return std::string("1:1 in") + name;
  const auto extent = [&](auto coordinate) {
    const auto [low, high] = std::ranges::minmax(drawing.points, {}, coordinate);
    return static_cast<double>(coordinate(high) - coordinate(low)) / 1000 / drawing.scale;
  };
  return fmt::format("1:1 in units of the model, {:.6g} x {:.6g}{}", extent([](const PaperPoint& p) { return p.x; }),
                     extent([](const PaperPoint& p) { return p.y; }), name);
}

std::string pixel_size(const std::string& png) {
  // After the signature the first chunk, IHDR, has width and height, four bytes each, the highest first.
  require(png.size() >= 24, "pixel_size: no PNG file");
  const auto number = [&](std::size_t at) {
    std::uint32_t n = 0;
    for (std::size_t k = at; k < at + 4; ++k) n = n << 8 | static_cast<std::uint8_t>(png[k]);
    return n;
  };
  return fmt::format("{} x {} pixels", number(16), number(20));
}

}  // namespace hsr::cli
