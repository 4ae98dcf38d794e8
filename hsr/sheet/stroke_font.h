#pragma once

#include <string_view>
#include <vector>

#include "geometry/point.h"

namespace hsr::internal {

/// A stroke of text: points end to end, in mm, y down.
using TextStroke = std::vector<Point2>;

/// Text in a single-stroke font, upright, in the proportions of ISO 3098 type B: capitals are `height` mm high, small letters 0.7 of it,
/// and lines are meant to be a tenth of it wide. So that every format, a plotter too, has the same letters.
///
/// It has ASCII, the Latin letters of western and central Europe, and signs of drawings. A line of text has no line breaks.
class StrokeFont {
 public:
  explicit StrokeFont(double height) : unit_(height / 10) {}

  /// mm from the left of the first letter to the right of the last.
  double width(std::string_view text) const;
  /// @param origin the left end of the base line
  std::vector<TextStroke> strokes(std::string_view text, const Point2& origin) const;
  /// Whether all of it can be written; a box stands for what cannot.
  static bool knows(std::string_view text);

 private:
  double unit_;  // mm
};

}  // namespace hsr::internal
