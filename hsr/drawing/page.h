#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace hsr {

/// The sheet, in millimetres.
struct Page {
  double width = 210, height = 297;
  double margin = 10;
  bool turns = true;  ///< named sizes: portrait or landscape, whichever suits the drawing better
  bool fits = false;  ///< the sheet is cut to the drawing and its margins
};

/// A point of the paper in thousandths of a millimetre: what a drawing carries.
struct PaperPoint {
  std::int64_t x = 0, y = 0;
  friend constexpr auto operator<=>(const PaperPoint&, const PaperPoint&) = default;
};

/// Millimetres of the page; lines are cut there.
struct PaperFrame {
  double left, top, right, bottom;
};

/// A0 ... A6, letter, WIDTHxHEIGHTmm, or fit. @throws InputError for anything else
Page parse_page(const std::string& text);

/// Paper length over model length, "1:5" or "2:1"; nothing: "fit" or "standard". @throws InputError for anything else
std::optional<double> parse_scale(const std::string& text);

/// Millimetres in a model unit: mm, cm, m or in. @throws InputError for anything else
double parse_unit(const std::string& text);

/// The unit of that many millimetres; "mm" where there is none.
std::string name_of_unit(double millimetres);

}  // namespace hsr
