#pragma once

#include <string>
#include <vector>

#include "hsr/check/comparison.h"
#include "hsr/write/comparison_pictures.h"
#include "hsr/write/plot_svg.h"

namespace hsr {

/// Error against run time and the like, as diagrams; each has a name for its file.
struct NamedPlot {
  std::string name;
  Plot plot;
};
std::vector<NamedPlot> comparison_plots(const Comparison& comparison);

/// What the page says of itself.
struct PageText {
  std::string title;
  std::vector<std::string> facts;  ///< model, view, machine, date, command
};

/// One page with all of it: two methods beside each other under a slider, diagrams, tables.
/// @param images of Comparison::pictures, in this order
std::string comparison_page(const Comparison& comparison, const std::vector<ComparisonImages>& images, const PageText& text);

/// A line for each method and size, under a line of names.
std::string comparison_csv(const Comparison& comparison);

}  // namespace hsr
