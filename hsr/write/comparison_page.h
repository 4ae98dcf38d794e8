#pragma once

#include <string>
#include <vector>

#include "hsr/check/comparison.h"
#include "hsr/write/comparison_pictures.h"

namespace hsr {

/// What the page says of itself.
struct PageText {
  std::string title;
  std::vector<std::string> facts;  ///< model, view, machine, date, command
};

/// One page with all of it: two methods beside each other under a slider, diagrams, tables.
/// @param images of Comparison::pictures, in this order
std::string comparison_page(const Comparison& comparison, const std::vector<ComparisonImages>& images, const PageText& text);

}  // namespace hsr
