#include "hsr/drawing/page.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "geometry/error.h"

namespace hsr {

namespace {

/// The number that is all of `text`, if it is one, finite and above 0.
std::optional<double> positive(std::string_view text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x) || x <= 0) return {};
  return x;
}

constexpr double longest_sheet = 1e6;  // a kilometre of paper: above that it is a slip of the pen

}  // namespace

Page parse_page(const std::string& text) {
  Page page;
  if (text == "fit") {
    page.fits = true;
    return page;
  }
  static constexpr struct {
    const char* name;
    double width, height;
  } sizes[] = {{"A0", 841, 1189}, {"A1", 594, 841}, {"A2", 420, 594}, {"A3", 297, 420},
               {"A4", 210, 297},  {"A5", 148, 210}, {"A6", 105, 148}, {"letter", 215.9, 279.4}};
  for (const auto& size : sizes) {
    std::string lower = size.name;
    lower[0] = lower[0] == 'A' ? 'a' : lower[0];
    if (text != size.name && text != lower) continue;
    page.width = size.width;
    page.height = size.height;
    return page;
  }
  const auto times = text.find('x');
  if (times != std::string::npos && text.ends_with("mm")) {
    const std::string_view all = text;
    const auto width = positive(all.substr(0, times)), height = positive(all.substr(times + 1, text.size() - times - 3));
    if (width && height && *width <= longest_sheet && *height <= longest_sheet) {
      page.width = *width;
      page.height = *height;
      page.turns = false;
      return page;
    }
  }
  throw InputError("page: found \"" + text + "\", expected A0 ... A6, letter, a size like 300x200mm, or fit");
}

std::optional<double> parse_scale(const std::string& text) {
  if (text == "fit" || text == "standard") return {};
  const auto colon = text.find(':');
  if (colon != std::string::npos) {
    const std::string_view all = text;
    const auto paper = positive(all.substr(0, colon)), model = positive(all.substr(colon + 1));
    if (paper && model && std::isfinite(*paper / *model) && *paper / *model > 0) return *paper / *model;
  }
  throw InputError("scale: found \"" + text + "\", expected fit, standard or a ratio like 1:5 (twice the size is 2:1)");
}

double parse_unit(const std::string& text) {
  if (text == "mm") return 1;
  if (text == "cm") return 10;
  if (text == "m") return 1000;
  if (text == "in") return 25.4;
  throw InputError("unit: found \"" + text + "\", expected mm, cm, m or in");
}

std::string name_of_unit(double millimetres) {
  for (const char* name : {"cm", "m", "in"})
    if (parse_unit(name) == millimetres) return name;
  return "mm";
}

}  // namespace hsr
