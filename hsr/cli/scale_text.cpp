#include "hsr/cli/scale_text.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "hsr/drawing/page.h"

namespace hsr::cli {

namespace {

/// To four digits, and never with an exponent where whole millimetres will do.
std::string millimetres(double x) { return x >= 1000 && x < 1e9 ? fmt::format("{:.0f}", x) : fmt::format("{:.4g}", x); }

/// "1:2" or "5:1" if the larger of the two is a number of at most two digits, zeros aside; else nothing.
std::string plain_ratio(double ratio) {
  const double larger = ratio < 1 ? 1 / ratio : ratio;
  const std::string text = fmt::format("{:.2g}", larger);
  if (!(larger < 1e15) || std::abs(std::strtod(text.c_str(), nullptr) - larger) > 1e-9 * larger) return "";
  const std::string number = larger < 100 ? text : fmt::format("{:.0f}", larger);
  return ratio < 1 ? "1:" + number : number + ":1";
}

std::string ratio_of(double ratio, const PageArguments& page) {
  return parse_scale(page.scale) ? page.scale : plain_ratio(ratio);
}

}  // namespace

std::string scale_text(double mm_per_unit, double unit, const PageArguments& page, bool is_perspective) {
  const std::string at = is_perspective ? " at the target" : "", per_unit = millimetres(mm_per_unit) + " mm per unit";
  const std::string ratio = ratio_of(mm_per_unit / unit, page);
  if (ratio.empty()) return "scale " + per_unit + at;
  return "scale " + ratio + at + " (" + per_unit + ")";
}

std::string scale_in_title(const Drawing& drawing, const DrawingOptions& options, const PageArguments& page) {
  if (!options.scale && !options.standard_scale) return "";
  return ", scale " + ratio_of(drawing.scale / options.unit, page);
}

}  // namespace hsr::cli
