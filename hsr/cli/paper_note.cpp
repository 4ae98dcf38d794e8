#include "hsr/cli/paper_note.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "hsr/drawing/page.h"

namespace hsr::cli {

namespace {

constexpr double dot = 0.5;     // mm: what is smaller each way is no larger than the pen
constexpr double legible = 2;   // mm
constexpr double wanted = 100;  // mm, at most: what a scale is proposed for

/// The largest scale of 1, 2 or 5 and zeros at which `size` is within what is wanted; nothing where there is no size.
std::optional<std::string> plain_scale(double size) {
  const double most = wanted / size;
  if (!(most > 1e-12 && most < 1e12)) return {};
  const double power = std::pow(10, std::floor(std::log10(most)));
  const double first = most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1;
  if (power >= 1) return fmt::format("{:.0f}:1", first * power);
  return fmt::format("1:{:.0f}", 1 / (first * power));
}

}  // namespace

std::string note_on_dot(double width, double height, std::optional<double> scale, double unit) {
  const double larger = std::max(width, height);
  if (!scale || !(larger > 0)) return "";
  const double mm = *scale * unit;
  if (!(larger * mm < dot)) return "";
  std::string text =
      fmt::format("the drawing is {:.3g} x {:.3g} mm on the paper, no more than a dot:", width * mm, height * mm);
  constexpr std::array<std::pair<const char*, const char*>, 3> units = {
      {{"cm", "centimetres"}, {"in", "inches"}, {"m", "metres"}}};
  for (const auto& [name, words] : units) {
    const double other = *scale * parse_unit(name);
    if (other <= mm || larger * other < legible) continue;
    text += fmt::format(" if the model is in {}, --unit {} makes it {:.3g} x {:.3g} mm;", words, name, width * other,
                        height * other);
    break;
  }
  if (const auto plain = plain_scale(larger * unit)) text += fmt::format(" --scale {} or", *plain);
  return text + " --scale fit shows it larger";
}

}  // namespace hsr::cli
